#pragma once

#include <exception>
#include <string>

namespace deltaform
{
  /// Message where the saved state in @p folder cannot be read: the folder, the cause @p error, what to do.
  std::string damaged_state(const std::string &folder, const std::exception &error);
} // namespace deltaform
