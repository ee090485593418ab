#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    /// The entries of a scene: a strip that is pressed by a round punch in ten increments, and @p more. The punch has
    /// no motion if these give it a force.
    inline std::vector<std::string> pressed_strip(const std::vector<std::string> &more = {})
    {
      std::vector<std::string> entries{"Blank/Points=0 0; 1 0",
                                       "Blank/Thickness=.02",
                                       "Blank/Elements=16",
                                       "Material/Model=linear elastic",
                                       "Material/Young's modulus=1e4",
                                       "Material/Poisson's ratio=.3",
                                       "Supports/Names=edge",
                                       "Supports/edge/Boundary=end",
                                       "Supports/edge/Component=z",
                                       "Tools/Names=punch",
                                       "Tools/punch/Shape=hemispherical punch",
                                       "Tools/punch/Radius=.5",
                                       "Tools/punch/Side=top",
                                       "Tools/punch/Position z=thickness/2",
                                       "Tools/punch/Motion=.05*t",
                                       "Steps/Stages=press",
                                       "Steps/press/Largest increment=.1"};
      const auto is_force = [](const std::string &entry) { return entry.rfind("Tools/punch/Force=", 0) == 0; };
      if (std::any_of(more.begin(), more.end(), is_force))
        entries.erase(std::find(entries.begin(), entries.end(), "Tools/punch/Motion=.05*t"));
      entries.insert(entries.end(), more.begin(), more.end());
      return entries;
    }
  } // namespace testing
} // namespace deltaform
