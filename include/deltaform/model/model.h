#pragma once

#include <deltaform/assembly/accounts.h>
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

#include <string>
#include <vector>

namespace deltaform
{
  class Workspace;

  /**
   * The terms of the current stage (body, loads, released forces, contact), what is prescribed in it, and the committed
   * state. It is const while an increment is solved: NextState has the equations, Workspace what they need. It changes
   * when an increment is accepted, a stage begins, or the blank is refined.
   */
  class Model
  {
  public:
    Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers);

    // The parts refer to each other.
    Model(const Model &) = delete;
    Model &operator=(const Model &) = delete;

    /// A stage begins: tools, loads and supports that end with the last stage become forces that fade out.
    /// @return names of force-driven tools that do not find the blank along their direction
    std::vector<std::string> begin_stage(const Stage &stage);

    /// Before the first stage: the blank is what an earlier operation has formed. What had held it fades out.
    void start_from(const KeyedArrays &formed);

    FormedStart &formed_start()
    {
      return formed_start_;
    }

    /// Mark what blank and contact want to be finer. @return is anything marked? Nothing while released forces fade out
    bool mark();

    /// Refine the marked cells; the committed state goes along, and so do @p steps that lead to it. Then find
    /// equilibrium anew: begin() at the same time.
    void refine(std::vector<Vector> &steps);

    /// Accept @p q, which was assembled last in @p workspace, as the state at the end of the increment.
    void commit(const Vector &q, const Workspace &workspace);

    /// @name What the next state is sought with
    ///@{
    const Body &body() const
    {
      return body_;
    }
    const ContactSet &contact_set() const
    {
      return contact_;
    }
    const SupportSet &supports() const
    {
      return supports_;
    }
    const StageTerms &terms() const
    {
      return terms_;
    }
    const ModelTimers &timers() const
    {
      return timers_;
    }
    ///@}

    const Actors &actors() const
    {
      return actors_;
    }

    const Blank &blank() const
    {
      return *actors_.blank;
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
      return terms_.energies(state_.work.tools, state_.work.loads, state_.work.dissipated_before);
    }

    /// Contact of the committed state.
    ContactAccount contact() const
    {
      return contact_account(contact_, actors_, state_.unknowns);
    }

    /// Unknowns, forces and works of the committed state; points are with the blank and the interfaces.
    const ModelState &committed_state() const
    {
      return state_;
    }

    const Vector &committed() const
    {
      return state_.unknowns;
    }

    /// Do forces of the last stage vanish in the next increment?
    bool releases_at_once() const
    {
      return state_.releases_at_once;
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

    /// See ForceBook::earlier_force(), of the committed state.
    Tensor1 earlier_force() const
    {
      return book_.earlier_force(state_);
    }

    /// See ForceBook::balance_error(), of the committed state.
    double balance_error() const
    {
      return book_.balance_error(state_);
    }

    /// See ForceBook::imbalance(), of the state that was assembled last into @p system.
    double imbalance(const System &system) const
    {
      return book_.imbalance(system, state_);
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

    /// Those of all stages.
    std::vector<const Term *> all_terms() const;

    /// An empty state with the present unknowns.
    void clear_state();

    /// The mesh has changed, and with it all that refers to its unknowns.
    void renumber();

    Actors &actors_;
    ModelTimers timers_;
    Body body_;
    ToolStops stops_;
    ContactSet contact_;
    Discretization discretization_;
    SupportSet supports_;
    ForceBook book_;
    StageTerms terms_;

    ModelState state_; ///< committed; body and contact points are with the blank and the interfaces
    FormedStart formed_start_;
  };
} // namespace deltaform
