#pragma once

#include <deltaform/base/timers.h>
#include <deltaform/blanks/blank.h>
#include <deltaform/contact/augmentation.h>
#include <deltaform/contact/contact_interface.h>
#include <deltaform/scene/boundary_conditions.h>
#include <deltaform/scene/released_forces.h>
#include <deltaform/scene/stage.h>
#include <deltaform/solver/newton.h>
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

  /// Work done on the blank since the start, other than by its own energies.
  struct Work
  {
    double tools = 0; ///< by the tools
    double loads = 0; ///< by loads, supports and released forces
  };

  /**
   * The equations of one increment: blank, loads, released forces and the contact pairs of the current stage, assembled
   * in this order, because penalty rules read the blank's stiffness before contact adds to it. Knows which unknowns are
   * prescribed and what is committed.
   */
  class FormingProblem : public NonlinearProblem
  {
  public:
    FormingProblem(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers);

    /// @name NonlinearProblem
    ///@{
    double typical_length() const override;
    Status assemble(const Vector &q, bool tangent) override;
    double limit_step(const Vector &q, Vector &d) const override;
    void prepare_step(const Vector &d) override;
    void advance(double factor) override;
    bool status_changed() const override;
    unsigned int patience() const override;
    bool consistent(double allowed_tension) const override;
    void allow_slack(double force) override;
    unsigned int correct() override;
    ///@}

    /// What is wrong with the place of a tool that comes with @p stage, seen from the committed state, in words; empty:
    /// nothing. Belongs before begin_stage(). Tools of the first stage are the scene's matter.
    std::string misplaced_tool(const Stage &stage) const;

    /// A stage begins: tools, loads and supports that end with the last stage become forces that fade out.
    void begin_stage(const Stage &stage);

    /// An increment that ends at @p time begins.
    void begin_increment(double time);

    /// Where the promise p <= delta is broken in the trial state, in words; empty if it is kept or none was made.
    std::string broken_promise() const;

    /// Start the continuation of first touches. @return false if no pair exists
    bool soften(double share);

    /// Mark what the blank and contact want to be finer in the committed state. @return is anything marked? Nothing
    /// while forces of an ended stage fade out: they belong to nodes.
    bool mark();

    /// Refine the marked cells and bring the committed state to the new mesh. Equilibrium is then to be
    /// found anew, with begin_increment() at the same time.
    void refine();

    /// Accept @p q as the state at the end of the increment.
    void commit(const Vector &q);

    /// Call @p action in every assembly of the tangent, when it holds the blank's and the loads' terms and not yet
    /// those of contact; empty: no more.
    void before_contact(std::function<void(const System &)> action);

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

    const std::vector<bool> &is_prescribed() const
    {
      return is_prescribed_;
    }

    /// Values of the prescribed unknowns at the end of the increment.
    const Vector &prescribed() const
    {
      return prescribed_;
    }

    const Vector &committed() const
    {
      return committed_;
    }

    /// Forces below this are round-off.
    double force_floor() const;

    /// Contact pairs that exist in the current stage.
    const std::vector<ContactInterface *> &active_pairs() const
    {
      return active_pairs_;
    }

    /// Nobody asks for energies.
    void forget_energy();

    const Work &work() const
    {
      return work_;
    }

    /// Force of the blank on each tool, committed.
    const std::vector<Tensor1> &tool_forces() const
    {
      return tool_forces_;
    }

    double travel(unsigned int tool) const;

    /// Sum of the forces (moments) of a support on the blank in the committed state. Of one that ended with the stage
    /// before: what is left of it.
    double reaction(unsigned int support) const;

    /// Resultant of a load on the blank in the committed state: r (axisymmetric: radial forces around the whole
    /// circumference) and z. Of one that ended with the stage before: what is left of it.
    const Tensor1 &load_force(const unsigned int load) const
    {
      return load_resultants_[load];
    }

    /**
     * How far the forces on the blank in the committed state are from balance: sum of the forces of tools, supports and
     * loads as they are reported over the largest of them, along z and, in plane strain, along x (the larger counts).
     */
    double balance_error() const;

    /// Do forces of the last stage vanish in one increment that begins at the committed state?
    bool releases_at_once() const;

    /// The committed state. load() belongs before resume_stage(). @throws SceneError if it is that of another scene.
    void save(std::ostream &stream) const;
    void load(std::istream &stream);

    /// Go on in the middle of a stage, from a loaded state.
    void resume_stage(const Stage &stage);

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
    Vector committed_, prescribed_, hold_;
    std::array<Vector, 2> translation_; ///< of the blank along r and z, by a unit
    ReleasedForces released_;
    std::string stage_name_;
    double time_ = 0;
    std::vector<std::size_t> visited_; ///< sets of active constraints met in this solve
    bool cycling_ = false;
    bool factors_due_ = false; ///< the rule has to predict in the next assembly
    std::vector<ContactInterface *> active_pairs_;
    std::function<void(const System &)> before_contact_; ///< mostly empty
    Augmentation augmentation_;
    std::vector<Tensor1> tool_forces_;
    std::vector<double> travels_;
    Vector load_forces_; ///< committed: loads, supports, released
    Vector reactions_; ///< committed: supports
    std::vector<Tensor1> load_resultants_;
    Work work_;
    double largest_force_ = 0; ///< norm of all nodal forces so far
    double largest_resultant_ = 0; ///< of a tool, a support or a load so far
    bool at_once_ = false; ///< see releases_at_once()
  };
} // namespace deltaform
