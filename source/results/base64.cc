#include "base64.h"

namespace deltaform
{
  std::string base64(const unsigned char *const bytes, const std::size_t n)
  {
    constexpr const char *digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((n + 2) / 3 * 4, '=');
    char *to      = text.data();
    std::size_t i = 0;
    for (; i + 3 <= n; i += 3, to += 4)
    {
      const unsigned int bits = (bytes[i] << 16u) | (bytes[i + 1] << 8u) | bytes[i + 2];
      to[0]                   = digits[bits >> 18u];
      to[1]                   = digits[(bits >> 12u) & 63u];
      to[2]                   = digits[(bits >> 6u) & 63u];
      to[3]                   = digits[bits & 63u];
    }
    if (i < n)
    {
      const unsigned int bits = (bytes[i] << 16u) | (i + 1 < n ? bytes[i + 1] << 8u : 0u);
      to[0]                   = digits[bits >> 18u];
      to[1]                   = digits[(bits >> 12u) & 63u];
      if (i + 1 < n)
        to[2] = digits[(bits >> 6u) & 63u];
    }
    return text;
  }
} // namespace deltaform
