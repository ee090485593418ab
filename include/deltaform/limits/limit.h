#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// How large a criterion of the blank (Limits/Criteria) may become, and what happens then.
  struct Limit
  {
    enum class Then : unsigned char
    {
      warn,
      end_stage, ///< the next one begins, at its own time
      end_run
    };

    std::string criterion;
    double most = 0; ///< in the unit of the criterion
    Then then = Then::warn;
  };

  /// Read the limits that a scene sets to the @p criteria of its blank.
  std::vector<Limit> read_limits(const Section &scene, const std::vector<std::string> &criteria);
} // namespace deltaform
