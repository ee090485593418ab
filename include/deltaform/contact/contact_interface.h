#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/contact_settings.h>
#include <deltaform/contact/factor_control.h>
#include <deltaform/contact/interface_friction.h>
#include <deltaform/contact/interface_state.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * One side of the blank against one tool: the loop over the contact points, their residual and tangent, and who of
   * them touches. Forces on the blank are lambda N - t s tau with N the normal, tau the tangent of the tool and s =
   * d(foot point)/d(node), averaged: derivation of residual and tangent in doc/theory/contact.md.
   */
  class ContactInterface
  {
  public:
    ContactInterface(const ContactSurface &surface, Tool &tool, const ContactSettings &settings, Section tool_section);

    // The parts refer to each other.
    ContactInterface(const ContactInterface &) = delete;
    ContactInterface &operator=(const ContactInterface &) = delete;

    const Tool &tool() const
    {
      return tool_;
    }

    const ContactProjector &projector() const
    {
      return projector_;
    }

    /// Null: without friction.
    const FrictionLaw *friction() const
    {
      return friction_ ? &friction_->law() : nullptr;
    }

    unsigned int n_nodes() const
    {
      return projector_.n_nodes();
    }

    ContactNode node(const Vector &q, const unsigned int i) const
    {
      return projector_.node(q, i);
    }

    /// Contact points of the last iteration, and of the last accepted increment.
    const std::vector<ContactPointState> &trial() const
    {
      return trial_.points;
    }

    const std::vector<ContactPointState> &committed() const
    {
      return committed_.points;
    }

    /// @name Unknowns: the travel of a force-driven tool, and one multiplier per node if the enforcement has them
    ///@{
    void set_dofs(DofIndex travel, DofIndex first_multiplier);

    DofIndex travel_dof() const
    {
      return travel_dof_;
    }

    DofIndex multiplier_dof(const unsigned int i) const
    {
      return first_multiplier_ + i;
    }

    /// Multiplier unknowns that belong to the committed forces.
    void start_multipliers(Vector &q) const;

    /// Where the tool is: travel at the trial state.
    double travel(const Vector &q) const
    {
      return tool_.force_driven() ? q[travel_dof_] : tool_.travel(trial_.time);
    }
    ///@}

    /// @name An increment
    ///@{
    /// Begin a stage at @p q and @p time: remember where the nodes are, so that the slip of a first touch is known.
    void begin_stage(const Vector &q, double time);

    /// Start an increment that ends at @p time: trial state from the committed one, allowed penetrations.
    void begin_increment(double time);

    /// See FactorControl::soften().
    void soften(const double share)
    {
      factors_.soften(share);
    }

    /// Store the blank's nodal stiffness blocks for the rule; contact has not yet been added to @p stiffness.
    void read_stiffness(const Vector &q, const StiffnessView &stiffness);

    /// Add C (p - delta) of the touching points, for the rule's coupling.
    void add_mismatch(const Vector &q, Vector &direction) const;

    /// Give every touching point its factor: @p coupling = K C (p - delta), or null if no rule needs it.
    void predict_factors(const Vector &q, const Vector *coupling);

    /// Residual and tangent of all points at @p q.
    void assemble(const Vector &q, AssemblyTarget &target);

    /// A Newton step @p d was computed from the last assembled state: what it makes of the forces.
    void prepare_step(const Vector &d);

    /// The step is taken by this factor; the next assembly is at the new place.
    void advance(double factor);

    /// Until the end of this increment a point with a smaller force than @p force, pressure or tension, stays what it
    /// is, touching or not. Where a flat part of the blank lies on a flat tool no point carries a force; all states are
    /// solutions, and the iteration would choose among them for ever.
    void allow_slack(const double force)
    {
      slack_ = std::max(slack_, force);
    }

    /// Did a node gain or lose contact in the last assembly?
    bool status_changed() const
    {
      return status_changed_;
    }

    /// Is no force tensile? Otherwise the state is not a solution, however small the residual.
    bool consistent(double allowed_tension) const;

    /// How far the tool can go before it touches, by the gaps of the last assembly; 0 if it touches.
    double free_travel() const;

    /// After convergence: let the rule correct the factors. @return the number of points whose factor has changed.
    unsigned int correct_factors()
    {
      return factors_.correct(trial_.points);
    }

    /// Shifts of all points, and the forces that augmentation makes of them (Uzawa). @return whether all gaps are small
    /// enough, with the tolerance times @p relaxation (at most delta)
    bool augmentation(std::vector<double> &shifts, std::vector<double> &forces, double relaxation) const;

    /// Set the shifts of all points, from @p next on. @return the position behind them
    const double *shift(const double *next);

    /// See FactorControl::broken_promise().
    std::pair<unsigned int, double> broken_promise() const
    {
      return FactorControl::broken_promise(trial_.points);
    }

    void commit(const Vector &q);

    /// After the blank's thickness was updated: count the work that this does at the same positions. Gaps and forces
    /// stay those of the accepted equilibrium.
    void refresh(const Vector &q);
    ///@}

    /// @name Between increments
    ///@{
    /// The blank has other nodes than before: points of all of them, without contact.
    void resize();

    /**
     * The blank was refined at the committed @p q: new nodes take over forces and factors per area, penetrations and
     * slip from the two old ones that @p parent_nodes names, if both touch. What that adds to the stored energy counts
     * as work of changing factors.
     */
    void transfer(const Vector &q, const std::vector<std::array<unsigned int, 2>> &parent_nodes);

    /// The tool leaves: hand the forces of the accepted equilibrium over to @p target and forget all contact. They are
    /// those that were in balance; the law evaluated again would find others, because the thickness was updated since.
    void release(const Vector &q, AssemblyTarget &target);

    /// Nobody asks for energies: they are zero from here on, and cost nothing.
    void forget_energy();
    ///@}

    /// @name Results
    ///@{
    /// Force of the blank on the tool in the trial state (full circumference or per unit width).
    const Tensor1 &tool_force() const
    {
      return tool_force_;
    }

    const ContactEnergy &energy() const
    {
      return committed_.energy;
    }

    unsigned int n_touching() const
    {
      return trial_.n_touching();
    }

    bool governed_by_floor(const unsigned int i) const
    {
      return factors_.governed_by_floor(i, committed_.points);
    }

    /// Displacement unknowns of a touching node and the tool's normal there.
    struct Frame
    {
      DofIndex r, z;
      Tensor1 normal;
    };

    /// Of all touching nodes, as assembled last.
    std::vector<Frame> frames() const;
    ///@}

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      // Also what only saves a search, or a resumed run may differ in a last digit from one that was not interrupted.
      const std::size_t n = committed_.points.size();
      archive &committed_ &projector_;
      if (committed_.points.size() != n)
        throw SceneError("The saved state has another number of contact points: it is damaged. Start again.");
      if (!Archive::is_loading::value)
        return;
      if (!counts_energy_)
        committed_.energy = ContactEnergy();
      trial_ = committed_;
    }

  private:
    /// What is computed of a point in an iteration and forgotten.
    struct Work
    {
      ContactNode node; ///< of a touching point at the last assembly
      Tensor1 normal; ///< the same
      double base_multiplier = 0, step_multiplier = 0; ///< estimates of lambda along a Newton step
    };

    /// Can point @p i be passed over without a search? Sets what does not need one.
    bool passed_over(unsigned int i, const ContactNode &node) const;

    /// A point that has no contact, whatever its force was.
    void leave(unsigned int i, const ContactNode &node, const Vector &q, AssemblyTarget &target);

    /// A point that may have contact.
    void meet(unsigned int i, const ContactNode &node, const Vector &q, AssemblyTarget &target);

    /// Gap of a projected point, with its round-off.
    double gap(const Projection &projection, const ContactNode &node, ContactPointState &state) const;

    /// First touch of a point within this increment: factors, and where its slip starts.
    void touch(unsigned int i, const ContactNode &node, const Projection &projection);

    /// Normal force of point @p i whose face is @p gap away from the tool, with what lies in series: the thickness, the
    /// continuation. Sets the gap that is left.
    NormalResponse normal_response(unsigned int i, double gap, double compliance);

    /// Status and normal force of point @p i at the gap that decides (of a penalty spring: its share of it).
    NormalResponse respond(unsigned int i, double gap) const;

    /// Is the force of the point, estimated and now, within the slack?
    bool is_idle(const ContactPointState &state, double gap) const;

    void add_point(unsigned int i,
                   const ContactNode &node,
                   const Projection &projection,
                   const NormalResponse &normal,
                   const FrictionResponse &friction,
                   AssemblyTarget &target);

    /// Slip in this increment of a point that touches or did at its start, over the whole increment: a length along the
    /// tool.
    double slip_of_increment(const Vector &q, unsigned int i) const;

    Tool &tool_;
    const ContactSettings &settings_;
    ContactProjector projector_;
    std::unique_ptr<InterfaceFriction> friction_; ///< null: none
    FactorControl factors_;

    DofIndex travel_dof_ = dealii::numbers::invalid_dof_index;
    DofIndex first_multiplier_ = dealii::numbers::invalid_dof_index;

    InterfaceState committed_, trial_;
    std::vector<Work> work_;
    bool counts_energy_ = true;
    bool status_changed_ = false;
    bool at_start_ = false; ///< no step has been made in this increment: only the last one knows who touches
    double slack_ = 0; ///< see allow_slack()
    Tensor1 tool_force_;
  };
} // namespace deltaform
