#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /// An entry that a sweep varies: "Contact/Allowed penetration=1e-3,1e-5".
  struct Variation
  {
    std::string entry;
    std::vector<std::string> values; ///< in order; of an interval none
    double first = 0., last = 0.; ///< of an interval "first:last", from which values are drawn at random
    bool interval = false;

    /**
     * Values are separated by commas. Those with commas of their own, such as tables, are separated by semicolons, and
     * those with semicolons too, such as points, stand in braces: "{0 0; 1 1},{0 0; 2 1}". "first:last:step" is
     * a range.
     * @param intervals is "first:last" an interval, or a value (a table of one row)?
     * @throws std::invalid_argument with a sentence
     */
    static Variation read(const std::string &text, bool intervals);
  };
} // namespace deltaform
