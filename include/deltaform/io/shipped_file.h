#pragma once

#include <string>

namespace deltaform
{
  /// A file that is installed with the program in share/deltaform, from the build folder or where it was installed:
  /// looked for in the folders above the library or the program. @return its path; empty if there is none
  std::string shipped_file(const std::string &name);
} // namespace deltaform
