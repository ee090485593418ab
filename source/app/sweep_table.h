#pragma once
// sweep.csv: what the runs of a sweep have in common; private to the sweep.
#include <deltaform/app/sweep.h>
#include <deltaform/io/units.h>

namespace deltaform
{
  /// Write a row per run that has ended. @throws SceneError if the file cannot be written
  void write_sweep_table(const std::string &folder,
                         const CommandLine &command,
                         const std::vector<SweepRun> &runs,
                         const Units &units);
} // namespace deltaform
