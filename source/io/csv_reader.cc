#include <deltaform/io/csv_reader.h>

namespace deltaform
{
  std::vector<std::string> csv_cells(const std::string &line)
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


  CsvReader::CsvReader(std::istream &stream)
    : stream_(stream)
  {
    std::string line;
    while (std::getline(stream_, line) && (line.empty() || line[0] == '#'))
    {
    }
    if (!line.empty() && line[0] != '#')
      names_ = csv_cells(line);
  }


  std::optional<std::vector<std::string>> CsvReader::next()
  {
    std::string line;
    if (!std::getline(stream_, line) || stream_.eof())
      return std::nullopt;
    return csv_cells(line);
  }
} // namespace deltaform
