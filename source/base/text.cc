#include <deltaform/base/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace deltaform
{
  namespace text
  {
    std::string trim(const std::string &text)
    {
      const char *const white = " \t\r\n\v\f";
      const auto first = text.find_first_not_of(white);
      if (first == std::string::npos)
        return {};
      return text.substr(first, text.find_last_not_of(white) - first + 1);
    }

    std::string unquoted(const std::string &text)
    {
      const std::string inner = trim(text);
      const bool quoted =
        inner.size() >= 2 && (inner.front() == '\'' || inner.front() == '"') && inner.back() == inner.front();
      return quoted ? trim(inner.substr(1, inner.size() - 2)) : inner;
    }

    std::vector<std::string> split(const std::string &text, const char separator)
    {
      std::vector<std::string> pieces;
      if (trim(text).empty())
        return pieces;
      int depth = 0;
      std::string piece;
      for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == separator && depth <= 0)
        {
          pieces.push_back(trim(piece));
          piece.clear();
        }
        else
          piece += c;
      }
      pieces.push_back(trim(piece));
      return pieces;
    }

    std::string join(const std::vector<std::string> &pieces, const std::string &separator)
    {
      std::string result;
      for (std::size_t i = 0; i < pieces.size(); ++i)
        result += (i == 0 ? "" : separator) + pieces[i];
      return result;
    }

    std::string format(const double value)
    {
      if (std::abs(value) < 1e7 && value == std::floor(value)) // 100000 rather than 1e5
        return fmt::format("{:.0f}", value);
      char buffer[32];
      // As many digits as the shortest number that is read back as the value.
      const char *const end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
      const auto digits = std::count_if(static_cast<const char *>(buffer),
                                        std::find(static_cast<const char *>(buffer), end, 'e'),
                                        [](const char c) { return c >= '0' && c <= '9'; });
      // 1e7 rather than 1e+07.
      std::string result = fmt::format("{:.{}g}", value, digits);
      const auto exponent = result.find('e');
      if (exponent != std::string::npos)
        result = result.substr(0, exponent + 1) + std::to_string(std::atoi(result.c_str() + exponent + 1));
      return result;
    }

    std::string rounded(const double value)
    {
      return format(std::strtod(fmt::format("{:.3e}", value).c_str(), nullptr));
    }

    unsigned int edit_distance(const std::string &a, const std::string &b)
    {
      const auto lower = [](const char c) { return std::tolower(static_cast<unsigned char>(c)); };
      std::vector<unsigned int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
      for (std::size_t j = 0; j <= b.size(); ++j)
        above[j] = static_cast<unsigned int>(j);
      for (std::size_t i = 1; i <= a.size(); ++i)
      {
        row[0] = static_cast<unsigned int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
          const unsigned int replace = above[j - 1] + (lower(a[i - 1]) != lower(b[j - 1]));
          row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
          if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
            row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above);
        above.swap(row);
      }
      return above.back();
    }

    std::string nearest(const std::string &name, const std::vector<std::string> &candidates)
    {
      const auto closer = [&name](const std::string &a, const std::string &b) {
        return edit_distance(name, a) < edit_distance(name, b);
      };
      const auto best = std::min_element(candidates.begin(), candidates.end(), closer);
      return best == candidates.end() ? std::string() : *best;
    }

    bool similar(const std::string &a, const std::string &b)
    {
      return edit_distance(a, b) <= std::max<std::size_t>(1, std::min(a.size(), b.size()) / 3);
    }
  } // namespace text
} // namespace deltaform
