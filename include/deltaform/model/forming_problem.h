#pragma once

#include <deltaform/base/timers.h>
#include <deltaform/blanks/blank.h>
#include <deltaform/contact/augmentation.h>
#include <deltaform/contact/contact_interface.h>
#include <deltaform/model/accounts.h>
#include <deltaform/model/boundary_conditions.h>
#include <deltaform/model/increment_problem.h>
#include <deltaform/model/model_state.h>
#include <deltaform/model/stage.h>
#include <deltaform/solver/linear_solver.h>
#include <deltaform/solver/system.h>

#include <functional>
#include <memory>
#include <vector>

namespace deltaform
{
  /// What the scene names, built in dependency order; shared by the parts that run it.
  struct Actors
  {
    std::unique_ptr<Blank> blank;
    std::vector<std::unique_ptr<Tool>> tools;
    std::unique_ptr<ContactSettings> contact;
    std::vector<std::unique_ptr<ContactInterface>> pairs; ///< one per tool, in the order of the tools
    std::vector<Support> supports;
    std::vector<Load> loads;
    std::vector<Stage> stages;
  };

  /**
   * The equations of one increment: blank, loads, released forces and the contact pairs of the current stage, assembled
   * in this order, because penalty rules read the blank's stiffness before contact adds to it. Knows which unknowns are
   * prescribed and what is committed.
   */
  class FormingProblem : public IncrementProblem, public ActiveSet
  {
  public:
    FormingProblem(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers);

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

    /// @name ActiveSet
    ///@{
    void prepare_step(const Vector &d) override;
    void advance(double factor) override;
    bool changed() const override;
    unsigned int patience() const override;
    bool consistent(double allowed_tension) const override;
    void allow_slack(double force) override;
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
      return scale_;
    }

    /// Of the numbers from which forces are computed, see Newton.
    const std::vector<double> &size() const
    {
      return size_;
    }

    /// Contact pairs that exist in the current stage.
    const std::vector<ContactInterface *> &active_pairs() const
    {
      return active_pairs_;
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

    /// Go to @p state, in the middle or at the end of @p stage: forwards or back, to a state of this model or of
    /// another one of the same scene. @throws SceneError if it does not fit
    void set_state(const ModelState &state, const Stage &stage);

  private:
    /// Who takes part in a stage, and which unknowns it prescribes.
    void enter_stage(const Stage &stage);

    void number_unknowns();

    /// Supports, loads and unknowns of the blank's present mesh.
    void renumber();

    void set_prescribed();

    /// Sum of forces on the unknowns of the blank.
    Tensor1 resultant(const Vector &forces) const;

    /// Unknowns to which contact may add entries of the tangent.
    std::vector<DofIndex> contact_unknowns() const;

    /// Tell the system what an algebraic multigrid has to know, or whoever factorizes the blank without contact.
    void describe_rigid_motions();

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
    std::vector<double> scale_, size_;
    std::vector<bool> is_fixed_, is_prescribed_;
    std::array<Vector, 2> translation_; ///< of the blank along r and z, by a unit
    std::string stage_name_;
    bool energies_wanted_ = true;

    ModelState state_; ///< committed; body and contact points are with the blank and the pairs
    double time_ = 0; ///< at the end of the increment that is tried
    Vector prescribed_;
    std::vector<std::size_t> visited_; ///< sets of active constraints met in this solve
    bool cycling_ = false;
    bool factors_due_ = false; ///< the rule has to predict in the next assembly
    std::vector<ContactInterface *> active_pairs_;
    std::function<void(const System &)> before_contact_; ///< mostly empty
    Augmentation augmentation_;
  };
} // namespace deltaform
