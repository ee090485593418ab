#pragma once

#include <deltaform/blanks/fields.h>
#include <deltaform/measures/probe.h>
#include <deltaform/reports/columns.h>
#include <deltaform/stage/actors.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// Tools, supports, loads and probes that columns carry in their names.
  struct ReportedNames
  {
    std::vector<std::string> tools, supports, loads;
    std::vector<std::string> pressures, other_loads; ///< loads that press on a face, and those that do not
    std::vector<std::string> beads; ///< loads that restrain a sheet
    std::vector<Probe> probes;
  };

  ReportedNames reported_names(const Actors &actors);

  /// @name What the parts of a model and of its increments have to report; tools, supports and loads by their names
  ///@{
  void describe_increment(Columns &columns);
  void describe_tools(const std::vector<std::string> &names, Columns &columns);
  void describe_cost(Columns &columns);
  void describe_contact(Columns &columns);
  void describe_thickness(Columns &columns);
  void describe_criteria(const std::vector<LargestCriterion> &criteria, Columns &columns);
  void describe_linear_solver(Columns &columns);
  void describe_mesh(Columns &columns);
  void describe_energies(Columns &columns);
  void describe_heat(Columns &columns);
  void describe_half_spaces(Columns &columns);
  void describe_supports(const std::vector<std::string> &names, Columns &columns);
  void describe_loads(const std::vector<std::string> &names, Columns &columns);
  /// Of those that do not press on a face.
  void describe_load_sizes(const std::vector<std::string> &names, Columns &columns);
  /// Of those that do.
  void describe_pressures(const std::vector<std::string> &names, Columns &columns);
  void describe_wrinkling(Columns &columns);
  void describe_beads(const std::vector<std::string> &names, Columns &columns);
  void describe_probes(const std::vector<Probe> &probes, Columns &columns);
  void describe_earlier_operation(Columns &columns);
  void describe_balance(Columns &columns);
  ///@}
} // namespace deltaform
