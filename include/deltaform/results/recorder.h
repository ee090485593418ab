#pragma once

#include <deltaform/reports/columns.h>
#include <deltaform/reports/observer.h>
#include <deltaform/results/output_settings.h>
#include <deltaform/results/snapshot.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// Of which states a record keeps tables.
  enum class Keep : unsigned char
  {
    asked, ///< as the scene has it (Output/Travels), and the last one of a run that stopped
    every_increment
  };

  /// What a run leaves, in memory instead of files.
  struct RunRecord
  {
    std::string title, units; ///< of the scene
    bool axisymmetric = true;
    int exit_status = 0;
    std::string message; ///< why it stopped; empty if it is done
    std::vector<Columns::Column> columns; ///< of the history
    std::vector<Columns::Row> history; ///< a row per increment
    std::vector<Snapshot> snapshots; ///< in the order of time
    std::string summary; ///< the text of summary.json
    std::string log; ///< notes and warnings, as on the console
  };

  /**
   * An observer that keeps what it sees in @p record.
   * @param columns of the history @param seconds that the run has taken so far
   */
  std::unique_ptr<Observer> make_recorder(RunRecord &record, Columns columns, const OutputSettings &output, Keep keep,
                                          std::function<double()> seconds);
} // namespace deltaform
