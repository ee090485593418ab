#pragma once

#include <deltaform/base/section.h>
#include <deltaform/materials/material.h>

namespace deltaform
{
  /**
   * Can a blank that asks for @p third serve the material chosen in @p section? A body of revolution has no direction
   * of rolling. Solids turn with the increment, but
   * they keep neither the axes of an anisotropic metal nor tensors of the history other than the plastic strain.
   * @throws SceneError
   */
  void check_usable(const Material &material, ThirdDirection third, bool axisymmetric, const Section &section);
} // namespace deltaform
