#pragma once

#include <deltaform/parameters/command_line.h>

#include <functional>
#include <string>
#include <vector>

namespace deltaform
{
  /// One run of a sweep.
  struct SweepRun
  {
    std::vector<std::string> values; ///< of the varied entries, in the order of the command line
    std::string folder;
    std::string main_tool; ///< empty if there is none
    int exit_status = -1; ///< -1: has not ended
    bool resume = false; ///< goes on from the state that it has left
    bool overdue = false; ///< it took longer than a run may, and was ended
  };

  /**
   * Run a scene once per combination of the varied values, each in a process and a folder of its own, and collect the
   * results in sweep.csv, which is written again whenever a run ends. The processes are copies of this one, in which
   * MPI must not have been started.
   * @param run carries out a run in its process, MPI included, and returns its exit status
   * @return exit status: 0 if all runs are done, else the largest of theirs
   * @throws SceneError before anything runs if one of the combinations is no valid scene
   */
  int run_sweep(const CommandLine &command, const std::function<int(const CommandLine &)> &run);
} // namespace deltaform
