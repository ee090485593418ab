#pragma once

#include <deltaform/base/csv_writer.h>
#include <deltaform/results/units.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// One row of history.csv.
  struct HistoryRow
  {
    struct ToolState
    {
      double travel = 0, force_z = 0, force_r = 0; ///< force of the blank on the tool
    };

    unsigned int           increment = 0;
    std::string            stage;
    double                 time = 0;
    std::vector<ToolState> tools;
    unsigned int           newton_iterations = 0, penalty_rounds = 0, cutbacks = 0;
    double                 max_penetration = 0, max_penetration_over_delta = 0, max_penetration_between_nodes = 0;
    double                 min_epsilon = 0, max_epsilon = 0, floor_share = 0;
    unsigned int           contact_pairs = 0;
    double                 min_thickness = 0;
    double                 tool_work = 0, load_work = 0, elastic_energy = 0, plastic_energy = 0, friction_energy = 0;
    double                 contact_energy = 0, epsilon_work = 0, thickness_work = 0, energy_error = 0;
  };

  /// The file history.csv: one row per increment, on disk as soon as it is known. Columns are part of the interface.
  class History
  {
  public:
    /**
     * @param path         of the file
     * @param comments     lines for its head
     * @param tools        names in the order of HistoryRow::tools
     * @param units        labels
     */
    History(const std::string &path, const std::vector<std::string> &comments, const std::vector<std::string> &tools, const Units &units);

    void
    append(const HistoryRow &row);

    /// Names of the columns for these tools, with their dimensions.
    static std::vector<CsvWriter::Column>
    columns(const std::vector<std::string> &tools, const Units &units);

  private:
    CsvWriter file_;
  };
} // namespace deltaform
