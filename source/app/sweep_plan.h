#pragma once
// Which runs a sweep has; private to the sweep.
#include <deltaform/app/sweep.h>

namespace deltaform
{
  /// The runs with the values that they are to have: all combinations, or samples.
  std::vector<SweepRun> plan_sweep(const CommandLine &command);

  /// The --set of a run: those of the command line, then the varied values.
  std::vector<std::string> assignments(const CommandLine &command, const SweepRun &run);
} // namespace deltaform
