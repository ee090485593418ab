#include <deltaform/model/model.h>
#include <deltaform/model/reported_columns.h>
#include <deltaform/results/condition_numbers.h>
#include <deltaform/results/observers.h>

#include <functional>
#include <ostream>
#include <utility>

namespace deltaform
{
  namespace
  {
    template <typename Named>
    std::vector<std::string> names_of(const std::vector<std::unique_ptr<Named>> &all)
    {
      std::vector<std::string> result;
      for (const auto &one : all)
        result.push_back(one->name());
      return result;
    }

    template <typename Named>
    std::vector<std::string> names_of(const std::vector<Named> &all)
    {
      std::vector<std::string> result;
      for (const auto &one : all)
        result.push_back(one.name);
      return result;
    }

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


  void print_columns(std::ostream &out)
  {
    const auto table = [&out](const std::string &title, const std::function<void(Columns &)> &describe) {
      Columns columns;
      describe(columns);
      out << "\n## " << title << "\n\n| column | unit | meaning |\n|---|---|---|\n";
      for (const auto &column : columns.columns())
        out << "| `" << column.name << "` | " << column.dimension << " | " << column.meaning << " |\n";
    };
    out << "# Columns of history.csv\n\n"
           "Made by `deltaform --print-columns`. What a scene does not have, or does not ask for, has no column.\n"
           "Tools, supports and loads stand with their names, underscores in place of blanks: a tool `die 2` has "
           "`die_2_force_z`.\n";
    table("Every scene", [](Columns &columns) {
      describe_increment(columns);
      describe_tools({"<tool>"}, columns);
      describe_cost(columns);
      describe_contact(columns);
      describe_thickness(columns);
    });
    table("With `Output/Condition number every`",
          [](Columns &columns) { ConditionReport::describe(columns, nullptr); });
    table("With an iterative linear solver", describe_linear_solver);
    table("With refinement", describe_mesh);
    table("Works and energies since the start; not with `Output/Energies = false`", describe_energies);
    table("Supports, loads and balance", [](Columns &columns) {
      describe_supports({"<support>"}, columns);
      describe_loads({"<load>"}, columns);
      describe_balance(columns);
    });
  }


  std::unique_ptr<ConditionReport> make_condition_report(const OutputSettings &output, Journal &journal, Timers &timers)
  {
    if (output.condition_every == 0)
      return nullptr;
    return std::make_unique<ConditionReport>(output.condition_every, output.condition_method, journal, timers);
  }


  Columns history_columns(const Model &model, const OutputSettings &output, const ConditionReport *const condition)
  {
    Columns columns;
    describe_increment(columns);
    describe_tools(names_of(model.actors().tools), columns);
    describe_cost(columns);
    describe_contact(columns);
    describe_thickness(columns);
    if (condition != nullptr)
      ConditionReport::describe(columns, condition);
    if (model.linear_solver().iterative())
      describe_linear_solver(columns);
    if (model.blank().refinement() != nullptr)
      describe_mesh(columns);
    if (output.energies)
      describe_energies(columns);
    describe_supports(names_of(model.actors().supports), columns);
    describe_loads(names_of(model.actors().loads), columns);
    describe_balance(columns);
    return columns;
  }


  std::vector<std::unique_ptr<Observer>> make_observers(const Model &model, const OutputSettings &output,
                                                        ResultsFolder &folder, const Checkpoint *const start)
  {
    std::vector<std::unique_ptr<Observer>> result;
    auto condition = make_condition_report(output, folder.journal(), folder.timers());
    Columns columns = history_columns(model, output, condition.get());
    if (condition != nullptr)
      result.push_back(std::move(condition));
    result.push_back(make_history_observer(folder, std::move(columns), resumption(start)));
    result.push_back(make_progress_observer(folder, output));
    result.push_back(make_table_observer(folder, output));
    result.push_back(make_picture_observer(folder, output));
    result.push_back(make_summary_observer(folder, output));
    result.push_back(make_checkpoint_observer(folder, output));
    return result;
  }
} // namespace deltaform
