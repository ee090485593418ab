#pragma once

#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/results/recorder.h>

#include <functional>

namespace deltaform
{
  /// Is told the columns and the row of every accepted increment; what it throws ends the run.
  using AfterIncrement = std::function<void(const std::vector<Columns::Column> &, const Columns::Row &)>;

  /**
   * Run the scene of @p tree; what the program writes into files is returned. No file is written, and a tree serves
   * one run. MPI is running (MpiSession).
   * @throws SceneError if the scene is wrong; a run that stopped is no error, see RunRecord::exit_status
   */
  RunRecord run_in_memory(ParameterTree &tree, Keep keep = Keep::asked, const AfterIncrement &after = {});
} // namespace deltaform
