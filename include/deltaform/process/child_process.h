#pragma once

#include <functional>
#include <optional>
#include <string>

namespace deltaform
{
  /**
   * Do @p job in a copy of this process; what it prints goes to the file @p console, what it returns is the exit
   * status. The copy has everything that is loaded and read by now, and pays for none of it. It has only the thread
   * that calls: there must be no others. MPI must not have been started; the job may do that.
   * @return the number of the new process @throws std::runtime_error if there can be none, or no such file
   */
  int start_process(const std::function<int()> &job, const std::string &console);

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

  /// Ask a process to end: SIGTERM.
  void ask_process_to_end(int process);

  /// End a started process at once; wait_for_process() reports it.
  void end_process(int process);
} // namespace deltaform
