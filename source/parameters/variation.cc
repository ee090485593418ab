#include <deltaform/parameters/text.h>
#include <deltaform/parameters/value_range.h>
#include <deltaform/parameters/variation.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    using Strings = std::vector<std::string>;

    /// "{a; b},{c; d}": what stands between braces.
    Strings in_braces(const std::string &text)
    {
      Strings result;
      std::size_t at = 0;
      while (true)
      {
        const std::size_t open = text.find_first_not_of(" \t", at);
        const std::size_t close = open == std::string::npos ? open : text.find('}', open);
        if (open == std::string::npos || text[open] != '{' || close == std::string::npos)
          throw std::invalid_argument("values in braces are written {...},{...}");
        result.push_back(text::trim(text.substr(open + 1, close - open - 1)));
        const std::size_t next = text.find_first_not_of(" \t", close + 1);
        if (next == std::string::npos)
          return result;
        if (text[next] != ',')
          throw std::invalid_argument("values in braces are separated by commas");
        at = next + 1;
      }
    }

    Strings pieces_of(const std::string &text)
    {
      const char separator = text.find(';') != std::string::npos ? ';' : ',';
      auto pieces = text::split(text, separator);
      if (separator == ';' && pieces.size() > 1 && pieces.back().empty())
        pieces.pop_back(); // "0: 0, 1: 1;" is one value
      Strings result;
      for (const auto &piece : pieces)
        for (const auto &value : values_of_range(piece))
          result.push_back(value);
      return result;
    }

    /// Is it "first:last", two numbers of which the second is larger?
    bool read_interval(const std::string &text, double &first, double &last)
    {
      char *end = nullptr;
      first = std::strtod(text.c_str(), &end);
      if (end == text.c_str() || *end != ':')
        return false;
      const char *const second = end + 1;
      last = std::strtod(second, &end);
      return end != second && *end == '\0' && std::isfinite(first) && std::isfinite(last) && first < last;
    }
  } // namespace


  Variation Variation::read(const std::string &text, const bool intervals)
  {
    Variation result;
    const auto equals = text.find('=');
    const std::string expected = "expected \"Section/Entry=value,value,...\"";
    if (equals == std::string::npos)
      throw std::invalid_argument(expected);
    result.entry = text::trim(text.substr(0, equals));
    const std::string values = text::trim(text.substr(equals + 1));
    result.interval = intervals && read_interval(values, result.first, result.last);
    if (!result.interval)
      result.values = !values.empty() && values.front() == '{' ? in_braces(values) : pieces_of(values);
    const bool has_gap = std::find(result.values.begin(), result.values.end(), "") != result.values.end();
    if (result.entry.empty() || (!result.interval && result.values.empty()) || has_gap)
      throw std::invalid_argument(expected);
    return result;
  }
} // namespace deltaform
