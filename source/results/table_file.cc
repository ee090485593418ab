#include <deltaform/results/table_file.h>

#include <cstdio>

namespace deltaform
{
  std::string
  table_name(const std::string &stem, const double travel)
  {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", travel);
    return stem + "_" + buffer + ".csv";
  }



  void
  write_table(const std::string &path, const std::vector<std::string> &comments, const Table &table, const Units &units)
  {
    std::vector<CsvWriter::Column> columns;
    for (unsigned int i = 0; i < table.names.size(); ++i)
      columns.push_back({table.names[i], units.of(table.units[i])});
    CsvWriter file(path, comments, columns);
    for (const auto &row : table.rows)
      file.row(row);
  }
} // namespace deltaform
