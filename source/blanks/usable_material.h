#pragma once

#include <deltaform/materials/material.h>

namespace deltaform
{
  class Section;

  /**
   * Can a blank that asks for @p third serve the material chosen in @p section? A body of revolution has no direction
   * of rolling, a law with rates wants to know the unit of time.
   * @throws SceneError
   */
  void check_usable(const Material &material, ThirdDirection third, bool axisymmetric, const Section &section);
} // namespace deltaform
