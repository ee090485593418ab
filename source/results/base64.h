#pragma once

#include <cstddef>
#include <string>

namespace deltaform
{
  /// Bytes as text, three as four characters, padded with '=' (RFC 4648, section 4).
  std::string base64(const unsigned char *bytes, std::size_t n);
} // namespace deltaform
