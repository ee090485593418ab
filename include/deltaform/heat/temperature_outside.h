#pragma once

#include <deltaform/materials/metal_heat.h>

#include <string>

namespace deltaform
{
  class Section;

  /// Read the entry Temperature of something that the blank exchanges heat with. @return its rise over the initial
  /// temperature of the blank. @throws SceneError if the metal would melt there
  double rise_outside(Section &section, const MetalHeat &metal, const std::string &sentence);
} // namespace deltaform
