#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// Path of the program that is running.
  std::string own_program();

  /**
   * Start a program beside this one; what it prints goes to the file @p console.
   * @return its process number @throws std::runtime_error if it cannot be started
   */
  int start_process(const std::vector<std::string> &arguments, const std::string &console);

  /// A process that has ended.
  struct EndedProcess
  {
    int process = 0;
    int exit_status = 0; ///< 128 + the signal if one ended it, as shells do
  };

  /**
   * Wait until one of the started processes ends, at most @p seconds (infinity: as long as it takes).
   * @return nothing if none has ended by then @throws std::runtime_error if there is none
   */
  std::optional<EndedProcess> wait_for_process(double seconds);

  /// End a started process at once; wait_for_process() reports it.
  void end_process(int process);
} // namespace deltaform
