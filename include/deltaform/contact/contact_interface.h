#pragma once

#include <deltaform/assembly/point_origin.h>
#include <deltaform/contact/contact_iteration.h>
#include <deltaform/contact/contact_settings.h>
#include <deltaform/contact/counterpart.h>
#include <deltaform/contact/interface_account.h>
#include <deltaform/contact/interface_states.h>
#include <deltaform/tools/tool.h>

#include <memory>
#include <vector>

namespace deltaform
{
  /**
   * One side of the blank against one tool: the state of its contact points, accepted and on trial, and how one follows
   * from the other. The search is ContactProjector's, the factors are FactorControl's, the forces are
   * ContactIteration's.
   */
  class ContactInterface
  {
  public:
    using Frame = ContactIteration::Frame;

    ContactInterface(const ContactSurface &surface,
                     const Tool &tool,
                     std::unique_ptr<Counterpart> counterpart,
                     const ContactSettings &settings,
                     Section tool_section);

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

    const NormalLaw &normal_law() const
    {
      return *settings_.normal_law;
    }

    /// Null: without friction.
    const FrictionLaw *friction() const
    {
      return friction_ ? &friction_->law() : nullptr;
    }

    unsigned int n_points() const
    {
      return projector_.n_points();
    }

    ContactPoint point(const Vector &q, const unsigned int i) const
    {
      return projector_.point(q, i);
    }

    /// At the accepted @p q, with the area that bore its force.
    ContactPoint accepted_point(const Vector &q, const unsigned int i) const
    {
      return projector_.accepted_point(q, i, states_.committed.points);
    }

    /// Contact points of the last iteration, and of the last accepted increment.
    const std::vector<ContactPointState> &trial() const
    {
      return states_.trial.points;
    }
    const std::vector<ContactPointState> &committed() const
    {
      return states_.committed.points;
    }

    /// @name Unknowns: those of the counterpart, and those of the normal law, one per point if it has any
    ///@{
    void set_dofs(const DofIndex of_counterpart, const DofIndex first_multiplier)
    {
      counterpart_->set_first_unknown(of_counterpart);
      iteration_.set_first_multiplier(first_multiplier);
    }

    /// Of a force-driven tool.
    DofIndex travel_dof() const
    {
      return counterpart_->first_unknown();
    }

    DofIndex multiplier_dof(const unsigned int i) const
    {
      return iteration_.multiplier_dof(i);
    }

    /// Unknowns of the law that belong to the committed forces.
    void start_multipliers(Vector &q) const
    {
      normal_law().start(states_.committed.points, multiplier_dof(0), q);
    }

    /// Where the tool is: travel at the trial state.
    double travel(const Vector &q) const
    {
      return tool().force_driven() ? q[travel_dof()] : tool().travel(states_.trial.time);
    }
    ///@}

    /// Begin a stage at @p q and @p time: remember where the points are, so that the slip of a first touch is known.
    void begin_stage(const Vector &q, const double time)
    {
      states_.begin_stage(q, time, counterpart_->way(q, time));
    }

    /// Start an increment that ends at @p time, at the committed @p q: trial state from the committed one, allowed
    /// penetrations.
    void begin_increment(const Vector &q, double time);

    /// See FactorControl, also of the next ones.
    void soften(const double share)
    {
      factors_.soften(share);
    }

    void read_stiffness(const Vector &q, const StiffnessView &stiffness)
    {
      factors_.read_stiffness(q, stiffness, states_.trial.points);
    }

    void add_mismatch(const Vector &q, Vector &direction) const
    {
      factors_.add_mismatch(q, shift(q), states_.trial.points, direction);
    }

    void predict_factors(const Vector &q, const Vector *coupling)
    {
      iteration_.discard_rows();
      factors_.predict(q, shift(q), coupling, states_.committed.points, states_.trial.points);
    }

    /// Close to equilibrium and after convergence: let the rule correct the factors. @return of how many points
    ///@{
    unsigned int correct_factors_early()
    {
      return iteration_.correct_early(states_.trial.points);
    }

    unsigned int correct_factors(const Vector &q)
    {
      iteration_.complete_flat(q, shift(q), states_.trial.points);
      iteration_.discard_rows();
      return factors_.correct(states_.trial.points) + projector_.wake_flat(states_.trial.points);
    }
    ///@}

    /// In the increment that was begun last (length).
    double allowed_penetration() const
    {
      return states_.delta();
    }

    bool governed_by_floor(const unsigned int i) const
    {
      return factors_.governed_by_floor(i, states_.committed.points);
    }

    /// Residual and tangent of all points at @p q.
    void assemble(const Vector &q, AssemblyTarget &target)
    {
      approach(q, nullptr);
      iteration_.assemble(q, shift(q), states_.trial.time, states_.committed.points, states_.trial.points, target);
    }

    /// Which points will touch after the step @p d from @p q, assembled last, if gaps are linear? Until the step
    /// is taken, assembly uses this set. @return does it differ from that of the last assembly?
    bool foresee(const Vector &q, const Vector &d)
    {
      approach(q, &d);
      return iteration_.foresee(q, shift(q), d, states_.trial.points);
    }

    /// Points that foresee() lets go take others with them, up to @p reach edges (or nodes) away.
    void peel(const unsigned int reach)
    {
      iteration_.peel(reach, states_.trial.points);
    }

    /// A Newton step @p d was computed from the last assembled state. It is taken by a factor; the next assembly is at
    /// the new place.
    void prepare_step(const Vector &d)
    {
      iteration_.prepare_step(d, states_.committed.points, states_.trial.points);
    }

    void advance(const double factor)
    {
      iteration_.advance(factor, states_.trial.points);
    }

    /// Remember the trial state, and go back to it: what was tried in between led nowhere.
    ///@{
    void keep()
    {
      states_.keep();
    }
    void go_back()
    {
      states_.go_back();
      iteration_.restart();
    }
    ///@}

    /// Hash of the set of touching points, as it was assembled last.
    std::size_t signature() const
    {
      return iteration_.signature(states_.trial.points);
    }

    /// Did a point gain or lose contact in the last assembly?
    bool status_changed() const
    {
      return iteration_.status_changed();
    }

    /// Is the state a solution, however small the residual: is no force tensile?
    bool consistent(double allowed_tension) const;

    /// How far the tool can go before it touches, by the gaps of the last assembly; 0 if it touches.
    double free_travel() const
    {
      return states_.free_travel();
    }

    /// Set the forces at zero gap of all points, from @p next on. @return the position after them
    const double *set_shifts(const double *next)
    {
      for (auto &state : states_.trial.points)
        state.shift = *next++;
      return next;
    }

    void commit(const Vector &q);

    /// The blank has other nodes than before: points of all of them, without contact.
    void resize();

    /// The blank was refined at the committed @p q: new points take over what the old ones know that @p origins names.
    void transfer(const Vector &q, const std::vector<PointOrigin> &origins);

    /// The tool leaves: hand the forces of the accepted equilibrium over to @p target and discard all contact. They are
    /// those that were in balance; the law evaluated again would find others, because the thickness was updated since.
    void release(const Vector &q, AssemblyTarget &target);

    const InterfaceAccount &account() const
    {
      return account_;
    }

    /// Switch energies off: they are zero from here on, and cost nothing.
    void count_no_energy()
    {
      account_.stop();
      states_.committed.energy = states_.trial.energy = ContactEnergy();
    }

    /// Force of the blank on the tool in the trial state (full circumference or per unit width).
    const Tensor1 &tool_force() const
    {
      return iteration_.tool_force();
    }

    const ContactEnergy &energy() const
    {
      return states_.committed.energy;
    }

    unsigned int n_touching() const
    {
      return states_.n_touching();
    }

    /// Of all touching points, as assembled last.
    std::vector<Frame> frames() const
    {
      return iteration_.frames(states_.trial.points);
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      // The starts of searches as well, else a resumed run may differ from one left alone in a last digit.
      archive &states_ &projector_;
      if (!Archive::is_loading::value)
        return;
      if (!account_.counts())
        states_.committed.energy = ContactEnergy();
      states_.trial = states_.committed;
    }

  private:
    /// Way of the counterpart at the trial state.
    Tensor1 shift(const Vector &q) const
    {
      return counterpart_->way(q, states_.trial.time);
    }

    /// Far edges (FarEdges) that may have contact at @p q plus @p step, if there is one, are near: the trial state
    /// begins there.
    void approach(const Vector &q, const Vector *step);

    const ContactSettings &settings_;
    const Tool &tool_;
    std::unique_ptr<Counterpart> counterpart_;
    ContactProjector projector_;
    std::unique_ptr<InterfaceFriction> friction_; ///< null: none
    FactorControl factors_;
    ContactIteration iteration_;
    InterfaceStates states_;
    InterfaceAccount account_;
  };
} // namespace deltaform
