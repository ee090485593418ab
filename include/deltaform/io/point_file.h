#pragma once

#include <istream>
#include <string>
#include <vector>

namespace deltaform
{
  /// A line of a file of points.
  struct PointLine
  {
    unsigned int number; ///< in the file, from 1
    std::string words; ///< separated by blanks
  };

  /// The lines that say something: # begins a comment, a comma separates as a blank does.
  std::vector<PointLine> point_lines(std::istream &file);

  /// Rows of @p columns numbers, a row a line; a first line without any number names the columns.
  /// @throws std::invalid_argument if the file cannot be read, or naming its line
  std::vector<std::vector<double>> read_rows(const std::string &file_name, unsigned int columns);
} // namespace deltaform
