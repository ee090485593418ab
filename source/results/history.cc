#include <deltaform/results/history.h>

namespace deltaform
{
  std::vector<CsvWriter::Column>
  History::columns(const std::vector<std::string> &tools, const Units &units)
  {
    std::vector<CsvWriter::Column> result{{"increment", "1"}, {"stage", "1"}, {"time", "time"}};
    for (const auto &tool : tools)
      {
        result.push_back({tool + "_travel", units.of("length")});
        result.push_back({tool + "_force_z", units.of("force")});
        result.push_back({tool + "_force_r", units.of("force")});
      }
    for (const auto &[name, dimension] : std::vector<std::pair<std::string, std::string>>{{"newton_iterations", "1"},
                                                                                          {"penalty_rounds", "1"},
                                                                                          {"cutbacks", "1"},
                                                                                          {"max_penetration", "length"},
                                                                                          {"max_penetration_over_delta", "1"},
                                                                                          {"max_penetration_between_nodes", "length"},
                                                                                          {"min_epsilon", "force/length"},
                                                                                          {"max_epsilon", "force/length"},
                                                                                          {"floor_share", "1"},
                                                                                          {"contact_pairs", "1"},
                                                                                          {"min_thickness", "length"},
                                                                                          {"tool_work", "force*length"},
                                                                                          {"load_work", "force*length"},
                                                                                          {"elastic_energy", "force*length"},
                                                                                          {"plastic_energy", "force*length"},
                                                                                          {"friction_energy", "force*length"},
                                                                                          {"contact_energy", "force*length"},
                                                                                          {"epsilon_work", "force*length"},
                                                                                          {"thickness_work", "force*length"},
                                                                                          {"energy_error", "1"}})
      result.push_back({name, units.of(dimension)});
    return result;
  }



  History::History(const std::string &             path,
                   const std::vector<std::string> &comments,
                   const std::vector<std::string> &tools,
                   const Units &                   units)
    : file_(path, comments, columns(tools, units))
  {}



  void
  History::append(const HistoryRow &row)
  {
    std::vector<CsvWriter::Cell> cells{static_cast<double>(row.increment), row.stage, row.time};
    for (const auto &tool : row.tools)
      cells.insert(cells.end(), {tool.travel, tool.force_z, tool.force_r});
    for (const double value : {static_cast<double>(row.newton_iterations),
                               static_cast<double>(row.penalty_rounds),
                               static_cast<double>(row.cutbacks),
                               row.max_penetration,
                               row.max_penetration_over_delta,
                               row.max_penetration_between_nodes,
                               row.min_epsilon,
                               row.max_epsilon,
                               row.floor_share,
                               static_cast<double>(row.contact_pairs),
                               row.min_thickness,
                               row.tool_work,
                               row.load_work,
                               row.elastic_energy,
                               row.plastic_energy,
                               row.friction_energy,
                               row.contact_energy,
                               row.epsilon_work,
                               row.thickness_work,
                               row.energy_error})
      cells.emplace_back(value);
    file_.row_of_cells(cells);
  }
} // namespace deltaform
