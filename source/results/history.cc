#include <deltaform/io/atomic_file.h>
#include <deltaform/io/csv_reader.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>
#include <deltaform/results/history.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace deltaform
{
  namespace
  {
    /// The units of the columns, from the last comment.
    std::vector<std::string> units_in(const std::string &comment)
    {
      const std::string opening = "# units: ";
      return comment.rfind(opening, 0) == 0 ? csv_cells(comment.substr(opening.size())) : std::vector<std::string>();
    }
  } // namespace


  History::History(const std::string &path, const std::vector<std::string> &comments,
                   const std::vector<CsvWriter::Column> &columns, const std::optional<Resumption> &resumption)
    : path_(path), comments_(comments), columns_(columns)
  {
    // The other processes write nowhere.
    if (resumption && ranks::first())
      read(*resumption);
    else
    {
      in_file_ = columns_;
      for (std::size_t i = 0; i < columns_.size(); ++i)
        place_.emplace_back(i);
    }
  }


  void History::read(const Resumption &resumption)
  {
    std::ifstream old(path_);
    if (!old)
      throw SceneError("Cannot resume: '" + path_ + "' cannot be read: " + std::strerror(errno) +
                       ". Start again without --resume.");
    std::string line, comment;
    while (std::getline(old, line) && !line.empty() && line[0] == '#')
      comment = line;
    const auto names = csv_cells(line);
    match(names, resumption);
    const auto units = units_in(comment);
    for (std::size_t i = 0; i < names.size(); ++i)
      in_file_.push_back({names[i], place_[i] ? columns_[*place_[i]].unit : i < units.size() ? units[i]
                                                                                             : "1"});

    kept_.emplace();
    unsigned long last = 0;
    while (std::getline(old, line) && !old.eof()) // one without its end: the run was killed in it
    {
      const auto cells = csv_cells(line);
      const unsigned long number = std::strtoul(cells[0].c_str(), nullptr, 10);
      if (cells.size() != names.size() || number != last + 1 || number > resumption.increment)
        break;
      last = number;
      kept_->push_back(line);
    }
    if (last < resumption.increment)
      throw SceneError("Cannot resume: the saved state is that of increment " + std::to_string(resumption.increment) +
                       ", but '" + path_ + "' " +
                       (last == 0 ? "has no rows" : "ends at increment " + std::to_string(last)) +
                       ": its other rows were lost, as by a power failure. Start again without --resume.");
  }


  void History::match(const std::vector<std::string> &names, const Resumption &resumption)
  {
    const auto fail = [&](const std::string &column, const std::string &where) {
      throw SceneError("Cannot resume: the columns of '" + path_ + "' are not those of this scene: '" + column +
                       "' is only in " + where + ". Start again without --resume.");
    };
    for (const auto &name : names)
    {
      const auto own = std::find_if(columns_.begin(), columns_.end(), [&](const auto &c) { return c.name == name; });
      if (own == columns_.end() && resumption.optional.count(name) == 0)
        fail(name, "the file");
      place_.push_back(own == columns_.end() ? std::nullopt
                                             : std::make_optional(static_cast<std::size_t>(own - columns_.begin())));
    }
    for (const auto &column : columns_)
      if (std::find(names.begin(), names.end(), column.name) == names.end())
      {
        if (resumption.optional.count(column.name) == 0)
          fail(column.name, "the scene");
        left_out_.push_back(column.name);
      }
  }


  void History::open()
  {
    if (!kept_)
    {
      file_.emplace(path_, comments_, in_file_);
      return;
    }
    // The new file gets the old one's name when it holds all that is kept.
    replace_file(path_, [this](const std::string &draft) {
      {
        const CsvWriter head(draft, comments_, in_file_);
      }
      std::ofstream rest(draft, std::ios::app);
      for (const auto &line : *kept_)
        rest << line << '\n';
      rest.close();
      if (!rest)
        throw SceneError("Cannot write '" + draft + "': " + std::strerror(errno) + ".");
    });
    kept_->clear();
    file_.emplace(CsvWriter::append(path_, in_file_));
  }


  void History::append(const std::vector<CsvWriter::Cell> &row)
  {
    std::vector<CsvWriter::Cell> cells;
    for (const auto &place : place_)
      cells.push_back(place ? row[*place] : CsvWriter::Cell(std::string()));
    file_->row_of_cells(cells);
  }
} // namespace deltaform
