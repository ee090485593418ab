#pragma once

#include <deltaform/base/timers.h>
#include <deltaform/model/accounts.h>
#include <deltaform/model/actors.h>
#include <deltaform/model/body.h>
#include <deltaform/model/contact_set.h>
#include <deltaform/model/force_book.h>
#include <deltaform/model/increment_problem.h>
#include <deltaform/model/model_state.h>
#include <deltaform/model/numbering.h>
#include <deltaform/model/support_set.h>
#include <deltaform/solver/linear_solver.h>
#include <deltaform/solver/system.h>

#include <functional>
#include <memory>
#include <vector>

namespace deltaform
{
  /**
   * The equations of one increment: the terms of the current stage (body, loads, released forces, contact), assembled
   * in this order, because penalty rules read the body's stiffness before contact adds to it; and the state that is
   * committed.
   */
  class Model : public IncrementProblem
  {
  public:
    Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers);

    // The parts refer to each other.
    Model(const Model &) = delete;
    Model &operator=(const Model &) = delete;

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
      return supports_.values();
    }
    const std::vector<bool> &is_prescribed() const override
    {
      return supports_.is_prescribed();
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
    /// @return names of force-driven tools that do not find the blank along their direction
    std::vector<std::string> begin_stage(const Stage &stage);

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
    ContactAccount contact() const
    {
      return contact_.account(state_.unknowns);
    }

    /// Force of the blank on each tool, committed.
    const std::vector<Tensor1> &tool_forces() const
    {
      return state_.tool_forces;
    }

    double travel(const unsigned int tool) const
    {
      return state_.travels[tool];
    }

    /// Sum of the forces (moments) of a support on the blank in the committed state. Of one that ended with the stage
    /// before: what is left of it.
    double reaction(const unsigned int support) const
    {
      return supports_.reaction(support, state_);
    }

    /// Resultant of a load on the blank in the committed state: r (axisymmetric: radial forces around the whole
    /// circumference) and z. Of one that ended with the stage before: what is left of it.
    const Tensor1 &load_force(const unsigned int load) const
    {
      return state_.load_resultants[load];
    }

    /// See ForceBook::balance_error(), of the committed state.
    double balance_error() const
    {
      return book_.balance_error(state_);
    }

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

    /// Unknowns, matrix and empty state of the blank's present mesh.
    void number_unknowns();

    /// The same after a change of the mesh, with all that refers to its unknowns.
    void renumber();

    Actors &actors_;
    LinearSolverSettings linear_solver_;
    Timers &timers_;
    Timers::Index timer_clear_, timer_body_, timer_sum_, timer_contact_, timer_commit_;
    std::unique_ptr<System> system_;
    Numbering numbering_;

    Body body_;
    ContactSet contact_;
    SupportSet supports_;
    ForceBook book_;
    std::vector<Term *> terms_; ///< of the current stage: the body, loads, released forces, contact
    bool energies_wanted_ = true;

    ModelState state_; ///< committed; body and contact points are with the blank and the interfaces
    double time_ = 0; ///< at the end of the increment that is tried
    std::function<void(const System &)> before_contact_; ///< mostly empty
  };
} // namespace deltaform
