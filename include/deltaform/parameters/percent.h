#pragma once

#include <cstdio>
#include <string>

namespace deltaform
{
  namespace text
  {
    /// A share as "12 %" for a sentence, with two digits.
    inline std::string percent(const double share)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, share < .995 ? "%.2g %%" : "%.0f %%", 100. * share);
      return buffer;
    }
  } // namespace text
} // namespace deltaform
