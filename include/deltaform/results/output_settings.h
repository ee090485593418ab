#pragma once

#include <deltaform/measures/measure.h>
#include <deltaform/solver/condition_method.h>
#include <deltaform/stage/stage.h>
#include <deltaform/tools/tool.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// What is written, and when.
  struct OutputSettings
  {
    OutputSettings(Section &section, const std::vector<std::unique_ptr<Tool>> &tools, const std::vector<Stage> &stages);

    std::string folder;
    unsigned int main_tool = invalid_index; ///< index of the tool whose travel names the files
    std::vector<double> travels; ///< at which tables are written
    std::vector<double> times; ///< further times at which tables are written
    bool at_stage_ends = false; ///< are tables written at the end of every stage?
    std::vector<double> travel_times; ///< all times of tables, ascending
    std::vector<std::unique_ptr<Measure>> measures; ///< of the finished part
    std::vector<double> frame_times; ///< of the pictures, ascending
    unsigned int condition_every = 0; ///< condition numbers in every so many increments; 0: never
    condition::Method condition_method = condition::Method::automatic;
    bool energies = true; ///< in the history
    double checkpoint_interval = 5; ///< seconds

  private:
    void read_measures(Section section);

    /// All times of tables.
    void find_table_times(const Section &section, const std::vector<std::unique_ptr<Tool>> &tools,
                          const std::vector<Stage> &stages);

    /// @param name of the tool; empty: the first that moves
    void choose_main_tool(const std::string &name, const std::vector<std::unique_ptr<Tool>> &tools, double end);

    /// The times at which the main tool has the travels.
    void find_travel_times(const Section &section, const std::vector<std::unique_ptr<Tool>> &tools, double end);
  };
} // namespace deltaform
