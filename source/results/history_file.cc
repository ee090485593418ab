#include "history_file.h"

#include <deltaform/base/atomic_file.h>
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
    /// The cells of a line of CSV, without the quotes of those that have them.
    std::vector<std::string> split_line(const std::string &line)
    {
      std::vector<std::string> cells(1);
      bool quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"')
          cells.back() += line[++i];
        else if (line[i] == '"')
          quoted = !quoted;
        else if (line[i] == ',' && !quoted)
          cells.emplace_back();
        else
          cells.back() += line[i];
      return cells;
    }

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
    std::string line;
    while (std::getline(old, line) && !line.empty() && line[0] == '#')
    {
    }
    std::vector<std::string> names;
    for (const auto &column : columns)
      names.push_back(column.name);
    if (ranks::first() && split_line(line) != names)
      throw SceneError("Cannot resume: the columns of '" + path + "' are not those of this scene.");

    // The new file gets the old one's name when it holds all that is kept; what follows still goes to it.
    if (!ranks::first())
      return CsvWriter(path, comments, columns);
    std::optional<CsvWriter> file;
    replace_file(path,
                 [&](const std::string &draft) {
                   file.emplace(draft, comments, columns);
                   while (std::getline(old, line) && !old.eof()) // one without its end: the run was killed in it
                   {
                     const auto cells = split_line(line);
                     if (cells.size() != columns.size() ||
                         std::strtoul(cells[0].c_str(), nullptr, 10) > last_increment)
                       break;
                     file->row_of_cells(parse(cells, columns));
                   }
                 });
    return std::move(*file);
  }
} // namespace deltaform
