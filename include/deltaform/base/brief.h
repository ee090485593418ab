#pragma once

#include <cstdio>
#include <string>

namespace deltaform
{
  namespace text
  {
    /// A number for a sentence, with four digits; files get all of them by format().
    inline std::string brief(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.4g", value);
      return buffer;
    }

    /// A share as "12 %", with two digits.
    inline std::string percent(const double share)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, share < .995 ? "%.2g %%" : "%.0f %%", 100. * share);
      return buffer;
    }
  } // namespace text
} // namespace deltaform
