#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// A part of the process: from the end of the one before to its own end.
  struct Stage
  {
    std::string name;
    double begin = 0, end = 1;
    double first_increment, smallest_increment, largest_increment;
    bool release_at_once = false; ///< of what ended with the stage before
    std::string ends_when; ///< conditions that end the stage before its end, see StageEnds
    bool continue_after_necking = false; ///< go on with a warning
  };

  /// Read the stages, in their order, from section Steps.
  std::vector<Stage> read_stages(Section &section);
} // namespace deltaform
