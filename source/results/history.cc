#include "history_file.h"

#include <deltaform/results/history.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// A number of the row: what it is called, its dimension, and where it is found.
    struct Number
    {
      const char *name;
      const char *dimension;
      double (*value)(const HistoryRow &row);
    };

    template <auto member>
    double get(const HistoryRow &row)
    {
      return static_cast<double>(row.*member);
    }

    using Row = HistoryRow;

    // The order of the columns after increment, stage, time and the tools.
    const std::vector<Number> costs_and_contact = {
      {"newton_iterations", "1", get<&Row::newton_iterations>},
      {"penalty_rounds", "1", get<&Row::penalty_rounds>},
      {"penalty_iterations", "1", get<&Row::penalty_iterations>},
      {"cutbacks", "1", get<&Row::cutbacks>},
      {"max_penetration", "length", get<&Row::max_penetration>},
      {"max_penetration_over_delta", "1", get<&Row::max_penetration_over_delta>},
      {"max_penetration_between_nodes", "length", get<&Row::max_penetration_between_nodes>},
      {"min_epsilon", "force/length", get<&Row::min_epsilon>},
      {"max_epsilon", "force/length", get<&Row::max_epsilon>},
      {"floor_share", "1", get<&Row::floor_share>},
      {"contact_pairs", "1", get<&Row::contact_pairs>},
      {"min_thickness", "length", get<&Row::min_thickness>}};

    const std::vector<Number> conditions = {{"condition_raw", "1", get<&Row::condition_raw>},
                                            {"condition_scaled", "1", get<&Row::condition_scaled>},
                                            {"condition_without_contact", "1", get<&Row::condition_without_contact>},
                                            {"rigid_modes", "1", get<&Row::rigid_modes>},
                                            {"digits_lost", "1", get<&Row::digits_lost>}};

    const std::vector<Number> meshes = {{"unknowns", "1", get<&Row::unknowns>},
                                        {"cells", "1", get<&Row::cells>},
                                        {"estimated_error", "1", get<&Row::estimated_error>}};
    const std::vector<Number> linear_solver = {{"linear_iterations", "1", get<&Row::linear_iterations>}};

    const std::vector<Number> energies = {{"tool_work", "force*length", get<&Row::tool_work>},
                                          {"elastic_energy", "force*length", get<&Row::elastic_energy>},
                                          {"plastic_energy", "force*length", get<&Row::plastic_energy>},
                                          {"friction_energy", "force*length", get<&Row::friction_energy>},
                                          {"contact_energy", "force*length", get<&Row::contact_energy>},
                                          {"epsilon_work", "force*length", get<&Row::epsilon_work>},
                                          {"thickness_work", "force*length", get<&Row::thickness_work>},
                                          {"load_work", "force*length", get<&Row::load_work>},
                                          {"energy_error", "1", get<&Row::energy_error>}};

    template <typename Action>
    void for_each_number(const HistoryOptions &options, const Action &action)
    {
      for (const auto *group : {&costs_and_contact, &conditions, &linear_solver, &meshes, &energies})
        if ((group != &conditions || options.condition) && (group != &linear_solver || options.iterative) &&
            (group != &meshes || options.refinement) && (group != &energies || options.energies))
          for (const Number &number : *group)
            action(number);
    }
  } // namespace

  std::string column_name(const std::string &name)
  {
    std::string result = name;
    std::replace(result.begin(), result.end(), ' ', '_');
    return result;
  }

  std::vector<CsvWriter::Column>
  History::columns(const std::vector<std::string> &tools, const Units &units, const HistoryOptions &options)
  {
    std::vector<CsvWriter::Column> result{{"increment", "1"}, {"stage", "1"}, {"time", "time"}};
    for (const auto &name : tools)
    {
      const std::string tool = column_name(name);
      result.push_back({tool + "_travel", units.of("length")});
      result.push_back({tool + "_force_z", units.of("force")});
      result.push_back({tool + "_force_r", units.of("force")});
    }
    for_each_number(options,
                    [&](const Number &number) {
                      result.push_back({number.name, units.of(number.dimension)});
                    });
    for (const auto &name : options.supports)
      result.push_back({column_name(name) + "_reaction", units.of("force")});
    for (const auto &name : options.loads)
    {
      result.push_back({column_name(name) + "_force_z", units.of("force")});
      result.push_back({column_name(name) + "_force_r", units.of("force")});
    }
    result.push_back({"balance_error", "1"});
    return result;
  }

  History::History(const std::string &path,
                   const std::vector<std::string> &comments,
                   const std::vector<std::string> &tools,
                   const Units &units,
                   const HistoryOptions &options)
    : options_(options),
      file_(options.resume_after ? reopen_history(path, comments, columns(tools, units, options), *options.resume_after)
                                 : CsvWriter(path, comments, columns(tools, units, options)))
  {
  }

  void History::append(const HistoryRow &row)
  {
    std::vector<CsvWriter::Cell> cells{static_cast<double>(row.increment), row.stage, row.time};
    for (const auto &tool : row.tools)
      cells.insert(cells.end(), {tool.travel, tool.force_z, tool.force_r});
    for_each_number(options_, [&](const Number &number) { cells.emplace_back(number.value(row)); });
    for (const double reaction : row.reactions)
      cells.emplace_back(reaction);
    for (const auto &[r, z] : row.load_forces)
      cells.insert(cells.end(), {z, r});
    cells.emplace_back(row.balance_error);
    file_.row_of_cells(cells);
  }
} // namespace deltaform
