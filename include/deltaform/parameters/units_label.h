#pragma once

#include <deltaform/parameters/section.h>

#include <string>

namespace deltaform
{
  /// The scene's label of its units: 'mm, N, MPa', or another text.
  inline std::string read_units_label(const Section &scene)
  {
    Section root = scene.root();
    return root.text("Units",
                     Default<std::string>("consistent"),
                     "Label of the units, for example 'mm, N, MPa'; with that of the time, 'mm, N, MPa, s', where a "
                     "material depends on the rate of strain.");
  }
} // namespace deltaform
