#pragma once

#include <deltaform/parameters/makers.h>
#include <deltaform/reports/columns.h>
#include <deltaform/reports/observer.h>
#include <deltaform/results/history.h>
#include <deltaform/results/output_settings.h>
#include <deltaform/results/results_folder.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <vector>

namespace deltaform
{
  class ConditionReport;

  /// Observers of every run by their names, besides its history. The last line of an observer's file is an Entry. A
  /// maker gives null if the settings do not ask for it; folder and settings live longer than what it makes.
  using ObserverMakers = Makers<Observer, ResultsFolder &, const OutputSettings &>;

  /// The usual maker.
  template <typename Own>
  std::unique_ptr<Observer> make_observer(ResultsFolder &folder, const OutputSettings &output)
  {
    return std::make_unique<Own>(folder, output);
  }

  /// Opens the folder when the run begins, or goes on, for certain; the first to be told.
  std::unique_ptr<Observer> make_folder_observer(ResultsFolder &folder,
                                                 std::function<void(std::ostream &)> print_scene);

  /// history.csv with these columns. @param resumption how the run goes on; none: it begins
  std::unique_ptr<Observer> make_history_observer(ResultsFolder &folder, Columns columns,
                                                  const std::optional<History::Resumption> &resumption);

  /// Measures condition numbers; null where the scene does not ask for them.
  std::unique_ptr<ConditionReport> make_condition_report(const OutputSettings &output, Journal &journal,
                                                         Timers &timers);

  /// All that a scene asks for, in the order of their turns. @param start as above
  std::vector<std::unique_ptr<Observer>> make_observers(const Model &model, const OutputSettings &output,
                                                        ResultsFolder &folder, const Checkpoint *start);
} // namespace deltaform
