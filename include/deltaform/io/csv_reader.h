#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// The cells of a line of CSV, without the quotes of those that have them.
  std::vector<std::string> csv_cells(const std::string &line);

  /// Reads a table as CsvWriter has written it: comments, a line of names, rows.
  class CsvReader
  {
  public:
    /// Reads the head. @p stream must live longer.
    explicit CsvReader(std::istream &stream);

    const std::vector<std::string> &names() const
    {
      return names_;
    }

    /// Cells of the next row, without the quotes of those that have them; nothing if there is none. A line without its
    /// end is none: the run was killed in it.
    std::optional<std::vector<std::string>> next();

  private:
    std::istream &stream_;
    std::vector<std::string> names_;
  };
} // namespace deltaform
