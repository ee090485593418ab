#include <deltaform/reports/condition_numbers.h>
#include <deltaform/reports/history_columns.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/results/observers.h>

#include <algorithm>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// Solver and Output may change when a run is resumed, and with them these columns.
    std::optional<History::Resumption> resumption(const Checkpoint *const start)
    {
      if (start == nullptr)
        return std::nullopt;
      Columns columns;
      ConditionReport::describe(columns, nullptr);
      describe_linear_solver(columns);
      describe_energies(columns);
      History::Resumption result;
      result.increment = start->increment;
      for (const auto &column : columns.columns())
        result.optional.insert(column.name);
      return result;
    }
  } // namespace


  std::unique_ptr<ConditionReport> make_condition_report(const OutputSettings &output, Journal &journal, Timers &timers)
  {
    if (output.condition_every == 0)
      return nullptr;
    return std::make_unique<ConditionReport>(output.condition_every, output.condition_method, journal, timers);
  }


  std::vector<std::unique_ptr<Observer>> make_observers(const Model &model, const OutputSettings &output,
                                                        ResultsFolder &folder, const Checkpoint *const start)
  {
    std::vector<std::unique_ptr<Observer>> result;
    auto condition = make_condition_report(output, folder.journal(), folder.timers());
    Columns columns = history_columns(model, output.energies, condition.get());
    if (condition != nullptr)
      result.push_back(std::move(condition));
    result.push_back(make_history_observer(folder, std::move(columns), resumption(start)));
    for (const auto &name : ObserverMakers::names())
      if (auto observer = ObserverMakers::make(name, folder, output))
        result.push_back(std::move(observer));
    std::stable_sort(result.begin(), result.end(),
                     [](const auto &a, const auto &b) { return a->turn() < b->turn(); });
    return result;
  }
} // namespace deltaform
