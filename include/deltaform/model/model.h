#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/increment/increment_problem.h>
#include <deltaform/model/discretization.h>
#include <deltaform/model/force_book.h>
#include <deltaform/model/formed_start.h>
#include <deltaform/model/model_state.h>
#include <deltaform/model/model_timers.h>
#include <deltaform/model/support_set.h>
#include <deltaform/stage/actors.h>
#include <deltaform/stage/body.h>
#include <deltaform/stage/contact_account.h>
#include <deltaform/stage/contact_set.h>
#include <deltaform/stage/stage_terms.h>
#include <deltaform/stage/tool_stops.h>

#include <algorithm>
#include <functional>
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

    /// @name Equations
    ///@{
    double typical_length() const override
    {
      return actors_.blank->typical_length();
    }
    Status assemble(const Vector &q, bool tangent) override;
    bool assemble_foreseen(const Vector &q) override;
    double limit_step(const Vector &q, Vector &d) const override
    {
      return std::min(contact_.limit_travels(d, typical_length()), actors_.blank->admissible_step(q, d));
    }
    ActiveSet *active_set() override
    {
      return contact_.empty() ? nullptr : &contact_;
    }
    unsigned int correct_early() override
    {
      return contact_.correct_early();
    }

    unsigned int correct() override
    {
      return contact_.correct();
    }
    ///@}

    /// @name IncrementProblem
    ///@{
    void begin(double time, double ratio) override;
    bool soften(const double share) override
    {
      return contact_.soften(share);
    }
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
    IncrementSize increment_size(const Vector &dq) const override
    {
      return actors_.blank->increment_size(dq);
    }
    std::string broken_promise() const override
    {
      return contact_.broken_promise(state_.unknowns);
    }
    bool releases_at_once() const override
    {
      return state_.releases_at_once;
    }
    std::string describe(const DofIndex unknown) const override
    {
      return unknown < actors_.blank->n_dofs() ? actors_.blank->describe_dof(unknown) : "";
    }
    ///@}

    /// A stage begins: tools, loads and supports that end with the last stage become forces that fade out.
    /// @return names of force-driven tools that do not find the blank along their direction
    std::vector<std::string> begin_stage(const Stage &stage);

    /// Before the first stage: the blank is what an earlier operation has formed. What had held it fades out.
    void start_from(const KeyedArrays &formed);

    FormedStart &formed_start()
    {
      return formed_start_;
    }

    /// Discard what was tried since the last commit. @param time of the state that is looked for next
    void discard(double time);

    /// Mark what blank and contact want to be finer. @return is anything marked? Nothing while released forces fade out
    bool mark();

    /// Refine the marked cells; the committed state goes along. Then find equilibrium anew: begin() at the same time.
    void refine();

    /// Accept @p q as the state at the end of the increment.
    void commit(const Vector &q);

    /// Call @p action in every assembly of a tangent that holds all terms but those of contact; empty: no more.
    void before_contact(std::function<void(const System &)> action)
    {
      before_contact_ = std::move(action);
    }

    const Actors &actors() const
    {
      return actors_;
    }

    const Blank &blank() const
    {
      return *actors_.blank;
    }

    Discretization &discretization()
    {
      return discretization_;
    }

    const Discretization &discretization() const
    {
      return discretization_;
    }

    /// Contact interfaces that exist in the current stage.
    const std::vector<ContactInterface *> &interfaces() const
    {
      return contact_.interfaces();
    }

    /// Switch energies off.
    void count_no_energy()
    {
      const bool friction_is_heat = actors_.heat != nullptr;
      terms_.count_no_energy(!friction_is_heat);
    }

    /// Works and energies of the committed state.
    EnergyAccount energies() const
    {
      return terms_.energies(state_.work.tools, state_.work.loads);
    }

    /// Contact of the committed state.
    ContactAccount contact() const
    {
      return contact_account(contact_, actors_, state_.unknowns);
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

    /// Sum of the forces (moments) of a support on the blank, committed; of one that ended, what is left of it.
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

    /// Of the committed state; empty: none has begun.
    const std::string &stage() const
    {
      return state_.stage;
    }

    /// The committed state, as a value.
    ModelState state() const;

    /// Go to @p state, in the middle or at the end of @p stage: forwards or back (but not over a refinement), to a
    /// state of this model or of one whose scene has the same entries. @throws SceneError if it does not fit
    void set_state(const ModelState &state, const Stage &stage);

  private:
    /// Who takes part in a stage, and which unknowns it prescribes.
    void enter_stage(const Stage &stage);

    System &system()
    {
      return discretization_.system();
    }

    const System &system() const
    {
      return discretization_.system();
    }

    /// An empty state with the present unknowns.
    void clear_state();

    /// The mesh has changed, and with it all that refers to its unknowns.
    void renumber();

    Actors &actors_;
    ModelTimers timers_;
    Discretization discretization_;
    Body body_;
    ToolStops stops_;
    ContactSet contact_;
    SupportSet supports_;
    ForceBook book_;
    StageTerms terms_;

    ModelState state_; ///< committed; body and contact points are with the blank and the interfaces
    FormedStart formed_start_;
    double time_ = 0; ///< at the end of the increment that is tried
    std::function<void(const System &)> before_contact_; ///< mostly empty
  };
} // namespace deltaform
