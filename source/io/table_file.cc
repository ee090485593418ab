#include <deltaform/io/atomic_file.h>
#include <deltaform/io/table_file.h>

#include <fmt/core.h>

namespace deltaform
{
  namespace
  {
    /// The file gets its name when it is complete.
    template <typename WriteRows>
    void write_whole(const std::string &path,
                     const std::vector<std::string> &comments,
                     std::vector<CsvWriter::Column> columns,
                     const Units &units,
                     const WriteRows &write_rows)
    {
      for (auto &column : columns)
        column.unit = units.of(column.unit);
      replace_file(path,
                   [&](const std::string &draft) {
                     CsvWriter file(draft, comments, columns, CsvWriter::Flush::when_told);
                     write_rows(file);
                     file.flush();
                   });
    }
  } // namespace

  std::string table_name(const std::string &stem, const double travel)
  {
    return fmt::format("{}_{:g}.csv", stem, travel + 0.); // + 0. turns -0 into 0
  }

  void
  write_table(const std::string &path, const std::vector<std::string> &comments, const Table &table, const Units &units)
  {
    std::vector<CsvWriter::Column> columns;
    for (std::size_t i = 0; i < table.names.size(); ++i)
      columns.push_back({table.names[i], table.units[i]});
    write_whole(path,
                comments,
                std::move(columns),
                units,
                [&table](CsvWriter &file) {
                  for (const auto &row : table.rows)
                    file.row(row);
                });
  }

  void write_table(const std::string &path,
                   const std::vector<std::string> &comments,
                   const std::vector<CsvWriter::Column> &columns,
                   const std::vector<std::vector<CsvWriter::Cell>> &rows,
                   const Units &units)
  {
    write_whole(path,
                comments,
                columns,
                units,
                [&rows](CsvWriter &file) {
                  for (const auto &row : rows)
                    file.row_of_cells(row);
                });
  }
} // namespace deltaform
