#pragma once

#include <deltaform/io/csv_writer.h>
#include <deltaform/io/table.h>
#include <deltaform/io/units.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// "profile_0.6.csv": @p stem, the travel with at most six digits, and the ending.
  std::string table_name(const std::string &stem, double travel);

  /// Write a table of numbers, whole or not at all. @throws SceneError
  void write_table(const std::string &path,
                   const std::vector<std::string> &comments,
                   const Table &table,
                   const Units &units);

  /// The same for rows that also contain words, one cell per column; the columns' units are dimensions, too.
  void write_table(const std::string &path,
                   const std::vector<std::string> &comments,
                   const std::vector<CsvWriter::Column> &columns,
                   const std::vector<std::vector<CsvWriter::Cell>> &rows,
                   const Units &units);
} // namespace deltaform
