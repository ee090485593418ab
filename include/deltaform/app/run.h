#pragma once

#include <deltaform/parameters/command_line.h>

namespace deltaform
{
  /// Do what the command line asks for; MPI is running. A sweep is refused: it begins before MPI, see run_sweep().
  /// @return the exit status. @throws SceneError, UsageError
  int run_command(const CommandLine &command);
} // namespace deltaform
