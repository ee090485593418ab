#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /// Columns of numbers with names and units, as they go into a CSV file.
  struct Table
  {
    std::vector<std::string> names;
    std::vector<std::string> units; ///< dimension of each column: "length", "stress", "force", "1"
    std::vector<std::vector<double>> rows;
  };
} // namespace deltaform
