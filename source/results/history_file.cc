#include "history_file.h"

#include <deltaform/base/atomic_file.h>
#include <deltaform/base/csv_reader.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// The stage as a word, all else as numbers. A number of ten digits is written again as it was.
    std::vector<CsvWriter::Cell> parse(const std::vector<std::string> &cells,
                                       const std::vector<CsvWriter::Column> &columns)
    {
      std::vector<CsvWriter::Cell> result;
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (columns[i].name == "stage")
          result.emplace_back(cells[i]);
        else
          result.emplace_back(std::strtod(cells[i].c_str(), nullptr));
      return result;
    }
  } // namespace

  CsvWriter reopen_history(const std::string &path,
                           const std::vector<std::string> &comments,
                           const std::vector<CsvWriter::Column> &columns,
                           const unsigned int last_increment)
  {
    std::ifstream old(ranks::first() ? path : "/dev/null");
    if (!old)
      throw SceneError("Cannot resume: '" + path + "' cannot be read: " + std::strerror(errno) + ".");
    CsvReader reader(old);
    std::vector<std::string> names;
    for (const auto &column : columns)
      names.push_back(column.name);
    if (ranks::first() && reader.names() != names)
      throw SceneError("Cannot resume: the columns of '" + path + "' are not those of this scene.");

    // The new file gets the old one's name when it holds all that is kept; what follows still goes to it.
    if (!ranks::first())
      return CsvWriter(path, comments, columns);
    std::optional<CsvWriter> file;
    replace_file(path,
                 [&](const std::string &draft) {
                   file.emplace(draft, comments, columns);
                   while (const auto cells = reader.next())
                   {
                     if (cells->size() != columns.size() ||
                         std::strtoul(cells->front().c_str(), nullptr, 10) > last_increment)
                       break;
                     file->row_of_cells(parse(*cells, columns));
                   }
                 });
    return std::move(*file);
  }
} // namespace deltaform
