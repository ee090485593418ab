#pragma once

#include <string>

namespace deltaform
{
  class Section;

  /// The scene's label of its units: 'mm, N, MPa', or another text.
  std::string read_units_label(const Section &scene);
} // namespace deltaform
