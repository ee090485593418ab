#include <deltaform/model/model.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/results/condition_numbers.h>
#include <deltaform/results/observers.h>

#include <algorithm>
#include <ostream>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// What columns are named after.
    struct Names
    {
      std::vector<std::string> tools, supports, loads, other_loads, pressures, beads; ///< `loads`: all
      std::vector<Probe> probes;
      std::vector<LargestCriterion> criteria;
      bool wrinkling; ///< is the flange watched?
    };

    template <typename Named>
    std::vector<std::string> names_of(const std::vector<std::unique_ptr<Named>> &all)
    {
      std::vector<std::string> result;
      for (const auto &one : all)
        result.push_back(one->name());
      return result;
    }

    Names names_of(const Actors &actors)
    {
      Names names{names_of(actors.tools),
                  {},
                  names_of(actors.loads),
                  {},
                  {},
                  {},
                  actors.probes,
                  actors.blank->fields().largest_criteria(),
                  actors.wrinkling != nullptr};
      for (const auto &load : actors.loads)
      {
        (load->pressed_face().empty() ? names.other_loads : names.pressures).push_back(load->name());
        if (load->restraint())
          names.beads.push_back(load->name());
      }
      for (const auto &support : actors.supports)
        names.supports.push_back(support.name);
      return names;
    }

    /// What a run has and asks for: its columns depend on it.
    struct Wishes
    {
      const Model &model;
      const OutputSettings &output;
      const ConditionReport *report; ///< null: no condition numbers
    };

    void describe_every_scene(const Names &names, const ConditionReport *, Columns &columns)
    {
      describe_increment(columns);
      describe_tools(names.tools, columns);
      describe_cost(columns);
      describe_contact(columns);
      describe_thickness(columns);
    }

    void describe_limits(const Names &names, const ConditionReport *, Columns &columns)
    {
      describe_criteria(names.criteria, columns);
      if (names.wrinkling)
        describe_wrinkling(columns);
    }

    void describe_forces(const Names &names, const ConditionReport *, Columns &columns)
    {
      describe_supports(names.supports, columns);
      describe_loads(names.loads, columns);
      describe_balance(columns);
      describe_load_sizes(names.other_loads, columns);
      describe_beads(names.beads, columns);
    }

    /// Columns that hang on no names.
    template <void (*describe)(Columns &)>
    void alone(const Names &, const ConditionReport *, Columns &columns)
    {
      describe(columns);
    }

    /// Columns that a history has together.
    struct Group
    {
      const char *title; ///< on the page
      bool (*wanted)(const Wishes &wishes);
      void (*describe)(const Names &names, const ConditionReport *report, Columns &columns);
    };

    /// In the order of a history.
    const std::vector<Group> &groups()
    {
      static const auto always = [](const Wishes &) { return true; };
      static const std::vector<Group> all = {
        {"Every scene", always, describe_every_scene},
        {"With `Output/Condition number every`", [](const Wishes &wishes) { return wishes.report != nullptr; },
         [](const Names &, const ConditionReport *report, Columns &columns) {
           ConditionReport::describe(columns, report);
         }},
        {"With an iterative linear solver",
         [](const Wishes &wishes) { return wishes.model.discretization().linear_solver().iterative(); },
         alone<describe_linear_solver>},
        {"With refinement", [](const Wishes &wishes) { return wishes.model.blank().adaptive() != nullptr; },
         alone<describe_mesh>},
        {"With `Limits/Criteria` and `Limits/Flange wrinkling`", always, describe_limits},
        {"Works and energies since the start; not with `Output/Energies = false`",
         [](const Wishes &wishes) { return wishes.output.energies; }, alone<describe_energies>},
        {"With `Material/Heat/Conductivity`; heat since the start",
         [](const Wishes &wishes) { return wishes.model.actors().heat != nullptr; }, alone<describe_heat>},
        {"With a tool whose `Heat/Body` is a half space",
         [](const Wishes &wishes) {
           const HeatFlow *const heat = wishes.model.actors().heat.get();
           return heat != nullptr && heat->tool_temperatures().has_value();
         },
         alone<describe_half_spaces>},
        {"Supports, loads and balance", always, describe_forces},
        {"Loads that press on a face",
         [](const Wishes &wishes) { return !names_of(wishes.model.actors()).pressures.empty(); },
         [](const Names &names, const ConditionReport *, Columns &columns) {
           describe_pressures(names.pressures, columns);
         }},
        {"Probes", [](const Wishes &wishes) { return !wishes.model.actors().probes.empty(); },
         [](const Names &names, const ConditionReport *, Columns &columns) {
           describe_probes(names.probes, columns);
         }}};
      return all;
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
    out << "# Columns of history.csv\n\n"
           "Made by `deltaform --print-columns`. What a scene does not have, or does not ask for, has no column.\n"
           "Tools, supports and loads stand with their names, underscores in place of blanks: a tool `die 2` has "
           "`die_2_force_z`. A probe (`Output/Probes`) adds a column `<probe>_<field>` for each of its fields, the "
           "columns of [profile_*.csv](output.md#profile_csv).\n";
    for (const auto &group : groups())
    {
      Columns columns;
      const LargestCriterion any{"<criterion>", "<criterion>", "its own", 0., {}};
      const std::vector<std::string> load{"<load>"};
      group.describe({{"<tool>"}, {"<support>"}, load, load, load, load, {}, {any}, true}, nullptr, columns);
      if (columns.columns().empty())
        continue;
      out << "\n## " << group.title << "\n\n| column | unit | meaning |\n|---|---|---|\n";
      for (const auto &column : columns.columns())
        out << "| `" << column.name << "` | " << column.dimension << " | " << column.meaning << " |\n";
    }
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
    for (const auto &group : groups())
      if (group.wanted({model, output, condition}))
        group.describe(names_of(model.actors()), condition, columns);
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
    for (const auto &name : ObserverMakers::names())
      if (auto observer = ObserverMakers::make(name, folder, output))
        result.push_back(std::move(observer));
    std::stable_sort(result.begin(), result.end(),
                     [](const auto &a, const auto &b) { return a->turn() < b->turn(); });
    return result;
  }
} // namespace deltaform
