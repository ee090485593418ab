#pragma once

#include <string>

namespace deltaform
{
  /// @p text as it stands between the quotes of an XML attribute.
  inline std::string xml_attribute(const std::string &text)
  {
    std::string result;
    for (const char c : text)
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
