#include <deltaform/parameters/text.h>

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

    namespace
    {
      /// Bytes of the UTF-8 character that begins at @p i; 0 if there is none.
      std::size_t character_at(const std::string &text, const std::size_t i)
      {
        const auto byte = [&text](const std::size_t k) {
          return static_cast<unsigned char>(k < text.size() ? text[k] : 0);
        };
        const unsigned char first = byte(i);
        const std::size_t n = first < 0x80                   ? 1
                              : first < 0xc2 || first > 0xf4 ? 0
                              : first < 0xe0                 ? 2
                              : first < 0xf0                 ? 3
                                                             : 4;
        for (std::size_t k = 1; k < n; ++k)
          if ((byte(i + k) & 0xc0u) != 0x80u)
            return 0;
        // Too long a form of a smaller number, a surrogate, or beyond the last character (RFC 3629).
        if ((first == 0xe0 && byte(i + 1) < 0xa0) || (first == 0xed && byte(i + 1) > 0x9f) ||
            (first == 0xf0 && byte(i + 1) < 0x90) || (first == 0xf4 && byte(i + 1) > 0x8f))
          return 0;
        return n;
      }
    } // namespace

    std::string printable(const std::string &text)
    {
      std::string result;
      for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t n = character_at(text, i);
        const auto first = static_cast<unsigned char>(text[i]);
        const bool plain = first >= 0x20 && first != 0x7f;
        // U+0080 to U+009f are control characters, too.
        const bool control = n == 2 && first == 0xc2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
        if (n > 0 && !control && (plain || first == '\n' || first == '\t'))
          result += text.substr(i, n);
        else
          result += fmt::format("\\x{:02x}", first);
        i += n > 0 && !control ? n : 1;
      }
      return result;
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

    std::string column_name(const std::string &name)
    {
      std::string result = name;
      std::replace(result.begin(), result.end(), ' ', '_');
      return result;
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
