#pragma once

#include <deltaform/analysis/analysis.h>
#include <deltaform/model/model.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/process/journal.h>
#include <deltaform/results/output_settings.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The composition root: builds exactly what the file names, in dependency order, checks it whole, and knows the
   * settings of the run. An absent feature is an absent object. @throws SceneError
   */
  class Scene
  {
  public:
    explicit Scene(ParameterTree &tree);

    ParameterTree &tree;
    std::string title, units;
    std::vector<std::string> notes; ///< what the user should know of how the scene was read
    std::string start_from; ///< folder of the earlier operation; empty: the blank is undeformed
    std::unique_ptr<LinearSolverSettings> linear_solver;
    Actors actors;

    std::unique_ptr<NewtonSettings> newton;
    std::unique_ptr<StepSettings> steps;
    std::unique_ptr<OutputSettings> output;

    /// How the stages are computed. The scene must live longer.
    AnalysisSettings analysis_settings() const;

  private:
    void read_supports_and_loads(const Section &root);
    void build_tools(const Section &root);
    void build_interfaces(const Section &root);

    /// Which points of the blank touch, where the scene leaves it open. @param section Tools
    void choose_contact_points(const Section &section);

    /// What a metal's name stands for (entry Material/Name). @throws SceneError
    void supply_material(const Section &root);

    /// What is wrong although every entry by itself is allowed: overlaps, stages in which nothing changes, ...
    void check(const Section &root) const;
    void check_functions(const Section &root) const;
    void check_columns(const Section &root) const;
    void check_tools(const Section &root) const;
    void check_lifted_tools(const Section &root) const;
    void check_linear_solver(const Section &root) const;
    void check_stages(const Section &root) const;
    void check_friction(const Section &root) const;
  };

  /// Make every registered object once, so that the tree knows all parameters there are.
  void declare_everything(ParameterTree &tree);
} // namespace deltaform
