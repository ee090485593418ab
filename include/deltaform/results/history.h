#pragma once

#include <deltaform/base/csv_writer.h>
#include <deltaform/results/units.h>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// One row of history.csv. Works and energies are those since the start of the run.
  struct HistoryRow
  {
    struct ToolState
    {
      double travel = 0, force_z = 0, force_r = 0; ///< force of the blank on the tool
    };

    unsigned int increment = 0;
    std::string stage;
    double time = 0;
    std::vector<ToolState> tools;
    unsigned int newton_iterations = 0, penalty_rounds = 0, cutbacks = 0;
    unsigned int linear_iterations = 0; ///< of an iterative linear solver, of all Newton iterations together
    unsigned int penalty_iterations = 0; ///< of the Newton iterations, those that the corrections of factors cost
    double max_penetration = 0, max_penetration_over_delta = 0, max_penetration_between_nodes = 0;
    double min_epsilon = 0, max_epsilon = 0;
    double floor_share = 0; ///< of the touching pairs, those whose penalty factor is at its floor
    unsigned int contact_pairs = 0;
    double min_thickness = 0;
    unsigned int unknowns = 0, cells = 0; ///< of the mesh, where it is refined
    double estimated_error = std::numeric_limits<double>::quiet_NaN(); ///< relative, in energy
    /// Condition numbers of the tangent as it is and scaled by its diagonal; NaN where unknown.
    double condition_raw = std::numeric_limits<double>::quiet_NaN();
    double condition_scaled = std::numeric_limits<double>::quiet_NaN();
    double condition_without_contact = std::numeric_limits<double>::quiet_NaN(); ///< apart from the rigid modes
    double digits_lost = std::numeric_limits<double>::quiet_NaN(); ///< by a direct solution
    unsigned int rigid_modes = 0; ///< of the blank without contact
    double tool_work = 0;
    double elastic_energy = 0, plastic_energy = 0, friction_energy = 0;
    double contact_energy = 0; ///< stored now in the penalty springs
    double epsilon_work = 0; ///< done by changing penalty factors at fixed penetration
    double thickness_work = 0; ///< done by updating the thickness between increments
    double load_work = 0; ///< of other loads and of supports
    double energy_error = 0; ///< works minus energies, over the largest of them
    double friction_error = 0; ///< to be expected of the friction energy, because increments are long; no column
    double balance_error = 0; ///< sum of the forces on the blank over the largest of them
    std::vector<double> reactions; ///< of the supports: sum of the forces (moments) that they exert on the blank
    std::vector<std::array<double, 2>> load_forces; ///< resultants of the loads on the blank: r, z
  };

  /// How a history is begun.
  struct HistoryOptions
  {
    bool condition = false; ///< with the columns condition_raw and condition_scaled
    bool refinement = false; ///< with unknowns, cells and estimated_error
    bool energies = true; ///< with works and energies
    bool iterative = false; ///< with the column linear_iterations
    std::vector<std::string> supports; ///< names in the order of HistoryRow::reactions
    std::vector<std::string> loads; ///< names in the order of HistoryRow::load_forces
    std::optional<unsigned int> resume_after; ///< go on with the file on disk, without what follows this increment
  };

  /// The name of a tool, support or load as columns carry it: underscores in place of blanks.
  std::string column_name(const std::string &name);

  /// The file history.csv: one row per increment, on disk as soon as it is known. Columns are part of the interface.
  class History
  {
  public:
    /**
     * @param path     of the file
     * @param comments lines for its head, without "#"
     * @param tools    names in the order of HistoryRow::tools
     * @param units    labels
     * @throws SceneError if the file cannot be written, or if the one to go on with has other columns
     */
    History(const std::string &path,
            const std::vector<std::string> &comments,
            const std::vector<std::string> &tools,
            const Units &units,
            const HistoryOptions &options = HistoryOptions());

    void append(const HistoryRow &row);

    /// Names of the columns for these tools and supports, with the labels of their units.
    static std::vector<CsvWriter::Column> columns(const std::vector<std::string> &tools,
                                                  const Units &units,
                                                  const HistoryOptions &options = HistoryOptions());

  private:
    HistoryOptions options_;
    CsvWriter file_;
  };
} // namespace deltaform
