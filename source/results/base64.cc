#include "base64.h"

#include <array>
#include <cstring>

namespace deltaform
{
  namespace
  {
    constexpr const char *digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    /// The two characters of each number of twelve bits: half the look-ups.
    std::array<std::array<char, 2>, 4096> pairs_of_digits()
    {
      std::array<std::array<char, 2>, 4096> result{};
      for (std::size_t bits = 0; bits < 4096; ++bits)
        result[bits] = {{digits[bits >> 6u], digits[bits & 63u]}};
      return result;
    }
  } // namespace


  std::string base64(const unsigned char *const bytes, const std::size_t n)
  {
    static const auto pairs = pairs_of_digits();
    std::string text((n + 2) / 3 * 4, '=');
    char *to = text.data();
    std::size_t i = 0;
    for (; i + 3 <= n; i += 3, to += 4)
    {
      const unsigned int bits = (bytes[i] << 16u) | (bytes[i + 1] << 8u) | bytes[i + 2];
      std::memcpy(to, pairs[bits >> 12u].data(), 2);
      std::memcpy(to + 2, pairs[bits & 4095u].data(), 2);
    }
    if (i < n)
    {
      const unsigned int bits = (bytes[i] << 16u) | (i + 1 < n ? bytes[i + 1] << 8u : 0u);
      to[0] = digits[bits >> 18u];
      to[1] = digits[(bits >> 12u) & 63u];
      if (i + 1 < n)
        to[2] = digits[(bits >> 6u) & 63u];
    }
    return text;
  }
} // namespace deltaform
