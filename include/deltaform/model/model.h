#pragma once

#include <deltaform/base/timers.h>
#include <deltaform/model/accounts.h>
#include <deltaform/model/actors.h>
#include <deltaform/model/contact_set.h>
#include <deltaform/model/increment_problem.h>
#include <deltaform/model/model_state.h>
#include <deltaform/model/numbering.h>
#include <deltaform/solver/linear_solver.h>
#include <deltaform/solver/system.h>

#include <functional>
#include <memory>
#include <vector>

namespace deltaform
{
  /**
   * The equations of one increment: blank, loads, released forces and the contact interfaces of the current stage,
   * assembled in this order, because penalty rules read the blank's stiffness before contact adds to it. Knows which
   * unknowns are prescribed and what is committed.
   */
  class Model : public IncrementProblem
  {
  public:
    Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers);

    /// @name Equations
    ///@{
    double typical_length() const override;
    Status assemble(const Vector &q, bool tangent) override;
    double limit_step(const Vector &q, Vector &d) const override;
    ActiveSet *active_set() override;
    unsigned int correct() override;
    ///@}

    /// @name IncrementProblem
    ///@{
    void begin(double time, double ratio) override;
    bool soften(double share) override;
    const Vector &committed() const override
    {
      return state_.unknowns;
    }
    const Vector &prescribed() const override
    {
      return prescribed_;
    }
    const std::vector<bool> &is_prescribed() const override
    {
      return is_prescribed_;
    }
    double force_floor() const override;
    IncrementSize increment_size(const Vector &dq) const override;
    std::string broken_promise() const override;
    bool releases_at_once() const override;
    std::string describe(DofIndex unknown) const override;
    std::string linear_failure() const override;
    unsigned int n_linear_iterations() const override;
    ///@}

    /// What is wrong with the place of a tool that comes with @p stage, seen from the committed state, in words; empty:
    /// nothing. Belongs before begin_stage(). Tools of the first stage are the scene's matter.
    std::string misplaced_tool(const Stage &stage) const;

    /// A stage begins: tools, loads and supports that end with the last stage become forces that fade out.
    void begin_stage(const Stage &stage);

    /// Forget what was tried since the last commit. @param time of the state that is looked for next
    void discard(double time);

    /// Mark what the blank and contact want to be finer in the committed state. @return is anything marked? Nothing
    /// while forces of an ended stage fade out: they belong to nodes.
    bool mark();

    /// Refine the marked cells and bring the committed state to the new mesh. Equilibrium is then to be
    /// found anew, with begin() at the same time.
    void refine();

    /// Accept @p q as the state at the end of the increment.
    void commit(const Vector &q);

    /// Call @p action in every assembly of the tangent, when it holds the blank's and the loads' terms and not yet
    /// those of contact; empty: no more.
    void before_contact(std::function<void(const System &)> action);

    const Actors &actors() const
    {
      return actors_;
    }

    const Blank &blank() const
    {
      return *actors_.blank;
    }

    System &system()
    {
      return *system_;
    }

    const System &system() const
    {
      return *system_;
    }

    /// As chosen for the present mesh.
    const LinearSolverSettings &linear_solver() const
    {
      return linear_solver_;
    }

    /// Is the blank's stiffness assembled and factorized once?
    bool on_linear_path() const
    {
      return linear_solver_.linear_path && actors_.blank->constant_stiffness();
    }

    const std::vector<double> &scale() const
    {
      return numbering_.scale;
    }

    /// Of the numbers from which forces are computed, see Newton.
    const std::vector<double> &size() const
    {
      return numbering_.size;
    }

    /// Contact interfaces that exist in the current stage.
    const std::vector<ContactInterface *> &interfaces() const
    {
      return contact_.interfaces();
    }

    /// Nobody asks for energies.
    void forget_energy();

    /// Is every penetration measured by the delta that is allowed?
    bool keeps_promise() const
    {
      return actors_.contact && actors_.contact->enforcement->uses_penalty();
    }

    /// Works and energies of the committed state.
    EnergyAccount energies() const;

    /// Contact of the committed state.
    ContactAccount contact() const;

    /// Force of the blank on each tool, committed.
    const std::vector<Tensor1> &tool_forces() const
    {
      return state_.tool_forces;
    }

    double travel(unsigned int tool) const;

    /// Sum of the forces (moments) of a support on the blank in the committed state. Of one that ended with the stage
    /// before: what is left of it.
    double reaction(unsigned int support) const;

    /// Resultant of a load on the blank in the committed state: r (axisymmetric: radial forces around the whole
    /// circumference) and z. Of one that ended with the stage before: what is left of it.
    const Tensor1 &load_force(const unsigned int load) const
    {
      return state_.load_resultants[load];
    }

    /**
     * How far the forces on the blank in the committed state are from balance: sum of the forces of tools, supports and
     * loads as they are reported over the largest of them, along z and, in plane strain, along x (the larger counts).
     */
    double balance_error() const;

    /// Of the committed state.
    double time() const
    {
      return state_.time;
    }

    /// The committed state, as a value.
    ModelState state() const;

    /// Go to @p state, in the middle or at the end of @p stage: forwards or back (but not over a refinement), to a
    /// state of this model or of one whose scene has the same entries. @throws SceneError if it does not fit
    void set_state(const ModelState &state, const Stage &stage);

  private:
    /// Who takes part in a stage, and which unknowns it prescribes.
    void enter_stage(const Stage &stage);

    void number_unknowns();

    /// Supports, loads and unknowns of the blank's present mesh.
    void renumber();

    void set_prescribed();

    void assemble_loads(const Vector &q, AssemblyTarget &target) const;

    /// Move a force-driven tool that touches nothing along its direction until it does.
    void bring_into_contact(const ContactInterface &pair);

    /// Forces on the unknowns of the blank from what ends with the last stage.
    void collect_released(const std::string &next_stage);

    Actors &actors_;
    LinearSolverSettings linear_solver_;
    Timers &timers_;
    Timers::Index timer_clear_, timer_blank_, timer_sum_, timer_contact_, timer_commit_;
    std::unique_ptr<System> system_;
    Numbering numbering_;
    std::vector<bool> is_prescribed_;
    std::string stage_name_;
    bool energies_wanted_ = true;

    ModelState state_; ///< committed; body and contact points are with the blank and the interfaces
    double time_ = 0; ///< at the end of the increment that is tried
    Vector prescribed_;
    ContactSet contact_;
    std::function<void(const System &)> before_contact_; ///< mostly empty
  };
} // namespace deltaform
