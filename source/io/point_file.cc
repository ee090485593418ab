#include <deltaform/io/point_file.h>
#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Nothing if it is no number, or one that cannot be computed with.
    std::optional<double> number(const std::string &word)
    {
      char *end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      return *end == '\0' && std::abs(value) <= ceilings::magnitude ? std::optional(value) : std::nullopt;
    }
  } // namespace


  std::vector<PointLine> point_lines(std::istream &file)
  {
    std::vector<PointLine> result;
    std::string line;
    for (unsigned int number = 1; std::getline(file, line); ++number)
    {
      if (number == 1 && line.rfind("\xef\xbb\xbf", 0) == 0) // the mark of UTF-8
        line.erase(0, 3);
      line = line.substr(0, line.find('#'));
      std::replace(line.begin(), line.end(), ',', ' ');
      line = text::trim(line);
      if (!line.empty())
        result.push_back({number, line});
    }
    return result;
  }


  std::vector<std::vector<double>> read_rows(const std::string &file_name, const unsigned int columns)
  {
    std::error_code error;
    if (std::filesystem::exists(file_name, error) && !std::filesystem::is_regular_file(file_name, error))
      throw std::invalid_argument("it is no file"); // a pipe may never end
    std::ifstream file(file_name);
    if (!file)
      throw std::invalid_argument(std::string("it cannot be read: ") + std::strerror(errno));
    std::vector<std::vector<double>> rows;
    bool first = true;
    for (const PointLine &line : point_lines(file))
    {
      std::istringstream words(line.words);
      std::vector<double> row;
      unsigned int n_words = 0;
      for (std::string word; words >> word; ++n_words)
        if (const auto value = number(word))
          row.push_back(*value);
      const bool names = first && row.empty();
      first = false;
      if (names)
        continue;
      if (row.size() != columns || n_words != columns)
        throw std::invalid_argument("line " + std::to_string(line.number) + ": '" +
                                    text::printable(line.words.substr(0, 80)) + "' is no row of " +
                                    std::to_string(columns) + " numbers");
      rows.push_back(row);
    }
    return rows;
  }
} // namespace deltaform
