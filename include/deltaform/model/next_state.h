#pragma once

#include <deltaform/increment/increment_problem.h>
#include <deltaform/model/model.h>
#include <deltaform/model/workspace.h>

#include <algorithm>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The equations for the state that follows the committed one of a model. The terms of the stage are assembled in
   * their order, because penalty rules read the body's stiffness before contact adds to it. The model stays as it is;
   * what is remembered lies in the workspace.
   */
  class NextState : public IncrementProblem
  {
  public:
    NextState(const Model &model, Workspace &workspace)
      : model_(model), workspace_(workspace)
    {
    }

    /// @name Equations
    ///@{
    double typical_length() const override
    {
      return model_.blank().typical_length();
    }
    Status assemble(const Vector &q, bool tangent) override;
    bool assemble_foreseen(const Vector &q) override;
    double limit_step(const Vector &q, Vector &d) const override
    {
      return std::min(model_.contact_set().limit_travels(d, typical_length()), model_.blank().admissible_step(q, d));
    }
    double imbalance() const override
    {
      return model_.imbalance(workspace_.system());
    }
    ActiveSet *active_set() override
    {
      return model_.contact_set().empty() ? nullptr : &workspace_.contact();
    }
    unsigned int correct_early() override
    {
      return workspace_.contact().correct_early();
    }
    unsigned int correct(const Vector &q) override
    {
      const unsigned int changed = workspace_.contact().correct(q);
      return changed > 0 ? changed : workspace_.pressure().correct(q);
    }
    ///@}

    /// @name IncrementProblem
    ///@{
    void begin(double time, double ratio) override;
    bool soften() override
    {
      return workspace_.contact().soften();
    }
    const Vector &committed() const override
    {
      return model_.committed();
    }
    const Vector &prescribed() const override
    {
      return workspace_.prescribed();
    }
    const std::vector<bool> &is_prescribed() const override
    {
      return model_.supports().is_prescribed();
    }
    double force_floor() const override;
    IncrementSize increment_size(const Vector &dq) const override
    {
      return model_.blank().increment_size(dq);
    }
    std::vector<SheetSection> trial_sections() const override
    {
      return model_.blank().trial_sections();
    }
    std::string broken_promise() const override
    {
      return model_.contact_set().broken_promise(model_.committed());
    }
    bool releases_at_once() const override
    {
      return model_.releases_at_once();
    }
    std::string describe(const DofIndex unknown) const override
    {
      return unknown < model_.blank().n_dofs() ? model_.blank().describe_dof(unknown) : "";
    }
    ///@}

  private:
    const Model &model_;
    Workspace &workspace_;
  };
} // namespace deltaform
