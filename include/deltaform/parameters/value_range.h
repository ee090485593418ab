#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The values of "first:last:step", both ends included where the step meets the last one: ".05:.2:.05" is .05, .1, .15
   * and .2. Any other text is its own only value, also tables such as "0: 0".
   * @throws std::invalid_argument if the step does not lead from the first to the last, or makes too many values
   */
  std::vector<std::string> values_of_range(const std::string &text);
} // namespace deltaform
