// Which columns the history of a scene has.
#include <deltaform/blanks/refinement.h>
#include <deltaform/reports/condition_numbers.h>
#include <deltaform/reports/history_columns.h>
#include <deltaform/reports/reported_columns.h>

#include <ostream>

namespace deltaform
{
  namespace
  {
    /// What a run has and asks for; by default all there can be, as the page has it.
    struct Reported
    {
      ReportedNames names;
      std::vector<LargestCriterion> criteria;
      const ConditionReport *condition = nullptr;
      bool condition_number = true, iterative = true, adaptive = true, wrinkling = true, energies = true, heat = true,
           half_spaces = true, formed_before = true;
    };

    Reported reported_by(const Model &model, const bool energies, const ConditionReport *const condition)
    {
      const Actors &actors = model.actors();
      const HeatFlow *const heat = actors.heat.get();
      const Adaptive *const mesh = model.blank().adaptive();
      return {reported_names(actors),
              actors.blank->fields().largest_criteria(),
              condition,
              condition != nullptr,
              model.discretization().linear_solver().iterative(),
              mesh != nullptr && mesh->settings().asked_for,
              actors.wrinkling != nullptr,
              energies,
              heat != nullptr,
              heat != nullptr && heat->tool_temperatures().has_value(),
              actors.formed_before};
    }

    /// Columns that a history has together.
    struct Group
    {
      const char *title; ///< on the page
      void (*describe)(const Reported &run, Columns &columns);
    };

    /// Columns that hang on no names, where a run has them.
    template <bool Reported::*asked, void (*describe)(Columns &)>
    void where(const Reported &run, Columns &columns)
    {
      if (run.*asked)
        describe(columns);
    }

    void describe_every_scene(const Reported &run, Columns &columns)
    {
      describe_increment(columns);
      describe_tools(run.names.tools, columns);
      describe_cost(columns);
      describe_contact(columns);
      describe_thickness(columns);
    }

    void describe_condition(const Reported &run, Columns &columns)
    {
      if (run.condition_number)
        ConditionReport::describe(columns, run.condition);
    }

    void describe_limits(const Reported &run, Columns &columns)
    {
      describe_criteria(run.criteria, columns);
      if (run.wrinkling)
        describe_wrinkling(columns);
    }

    void describe_forces(const Reported &run, Columns &columns)
    {
      describe_supports(run.names.supports, columns);
      describe_loads(run.names.loads, columns);
      describe_balance(columns);
      describe_load_sizes(run.names.other_loads, columns);
      describe_beads(run.names.beads, columns);
    }

    /// In the order of a history.
    const std::vector<Group> groups = {
      {"Every scene", describe_every_scene},
      {"With `Output/Condition number every`", describe_condition},
      {"With an iterative linear solver", where<&Reported::iterative, describe_linear_solver>},
      {"With refinement", where<&Reported::adaptive, describe_mesh>},
      {"With `Limits/Criteria` and `Limits/Flange wrinkling`", describe_limits},
      {"Works and energies since the start; not with `Output/Energies = false`",
       where<&Reported::energies, describe_energies>},
      {"With `Material/Heat/Conductivity`; heat since the start", where<&Reported::heat, describe_heat>},
      {"With a tool whose `Heat/Body` is a half space", where<&Reported::half_spaces, describe_half_spaces>},
      {"Supports, loads and balance", describe_forces},
      {"With `Start from`", where<&Reported::formed_before, describe_earlier_operation>},
      {"Loads that press on a face",
       [](const Reported &run, Columns &columns) { describe_pressures(run.names.pressures, columns); }},
      {"Probes", [](const Reported &run, Columns &columns) { describe_probes(run.names.probes, columns); }}};
  } // namespace


  void print_columns(std::ostream &out)
  {
    out << "# Columns of history.csv\n\n"
           "Made by `deltaform --print-columns`. What a scene does not have, or does not ask for, has no column.\n"
           "Tools, supports and loads stand with their names, underscores in place of blanks: a tool `die 2` has "
           "`die_2_force_z`. A probe (`Output/Probes`) adds a column `<probe>_<field>` for each of its fields, the "
           "columns of [profile_*.csv](output.md#profile_csv).\n";
    const LargestCriterion any{"<criterion>", "<criterion>", "its own", 0., {}};
    const std::vector<std::string> load{"<load>"};
    for (const auto &group : groups)
    {
      Columns columns;
      group.describe({{{"<tool>"}, {"<support>"}, load, load, load, load, {}}, {any}}, columns);
      if (columns.columns().empty())
        continue;
      out << "\n## " << group.title << "\n\n| column | unit | meaning |\n|---|---|---|\n";
      for (const auto &column : columns.columns())
        out << "| `" << column.name << "` | " << column.dimension << " | " << column.meaning << " |\n";
    }
  }


  Columns history_columns(const Model &model, const bool energies, const ConditionReport *const condition)
  {
    Columns columns;
    for (const auto &group : groups)
      group.describe(reported_by(model, energies, condition), columns);
    return columns;
  }
} // namespace deltaform
