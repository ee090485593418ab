#pragma once

#include <deltaform/parameters/text.h>

#include <string>

namespace deltaform
{
  /// @p raw as it stands between the quotes of an XML attribute; control characters have no place there.
  inline std::string xml_attribute(const std::string &raw)
  {
    std::string result;
    for (const char c : text::printable(raw))
      if (c == '<')
        result += "&lt;";
      else if (c == '&')
        result += "&amp;";
      else if (c == '"')
        result += "&quot;";
      else
        result += c;
    return result;
  }
} // namespace deltaform
