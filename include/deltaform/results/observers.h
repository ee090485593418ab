#pragma once

#include <deltaform/model/columns.h>
#include <deltaform/model/observer.h>
#include <deltaform/results/history.h>
#include <deltaform/results/output_settings.h>
#include <deltaform/results/results_folder.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <vector>

namespace deltaform
{
  class ConditionReport;

  /// @name What a scene may ask for
  /// Every one writes into @p folder, which must live longer.
  ///@{
  /// Opens the folder when the run begins, or goes on, for certain; the first to be told.
  std::unique_ptr<Observer> make_folder_observer(ResultsFolder &folder,
                                                 std::function<void(std::ostream &)> print_scene);
  std::unique_ptr<Observer> make_history_observer(ResultsFolder &folder, Columns columns,
                                                  const std::optional<History::Resumption> &resumption);
  std::unique_ptr<Observer> make_table_observer(ResultsFolder &folder, const OutputSettings &output);
  std::unique_ptr<Observer> make_picture_observer(ResultsFolder &folder, const OutputSettings &output);
  std::unique_ptr<Observer> make_progress_observer(ResultsFolder &folder, const OutputSettings &output);
  std::unique_ptr<Observer> make_summary_observer(ResultsFolder &folder, const OutputSettings &output);
  std::unique_ptr<Observer> make_checkpoint_observer(ResultsFolder &folder, const OutputSettings &output);
  ///@}

  /// Measures condition numbers; null where the scene does not ask for them.
  std::unique_ptr<ConditionReport> make_condition_report(const OutputSettings &output, Journal &journal,
                                                         Timers &timers);

  /// What a run reports of every increment. @param condition must live as long as the columns are used; may be null
  Columns history_columns(const Model &model, const OutputSettings &output, const ConditionReport *condition);

  /// The page on the columns of history.csv, in Markdown.
  void print_columns(std::ostream &out);

  /**
   * All that a scene asks for, in the order in which they have to be told: states are saved last, when what they count
   * on is written. @param start the state that the run goes on from; null: it begins
   */
  std::vector<std::unique_ptr<Observer>> make_observers(const Model &model, const OutputSettings &output,
                                                        ResultsFolder &folder, const Checkpoint *start);
} // namespace deltaform
