#pragma once

#include <exception>
#include <string>

namespace deltaform
{
  /// What is said of the saved state of a folder that cannot be read back, with what was met while it was read.
  std::string damaged_state(const std::string &folder, const std::exception &error);
} // namespace deltaform
