#pragma once

#include <cstdio>
#include <string>

namespace deltaform
{
  /// A number for a line that is read once.
  inline std::string short_number(const double value, const char *const format = "%.4g")
  {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
  }
} // namespace deltaform
