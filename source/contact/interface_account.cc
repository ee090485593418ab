#include <deltaform/contact/contact_measures.h>
#include <deltaform/contact/interface_account.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// In the tangential spring of a point with the force @p t.
    double stored_by_friction(const ContactPointState &state, const double t)
    {
      return state.touching && state.tangential_factor > 0 ? .5 * t * t / state.tangential_factor : 0.;
    }
  } // namespace


  void InterfaceAccount::begin(const unsigned int n_points)
  {
    friction_work_.assign(counts_ ? n_points : 0, 0.);
    growth_ = 0.;
  }


  void InterfaceAccount::add(const unsigned int point, const ContactPointState &before, const ContactPointState &now,
                             const double slip, const double open_gap, ContactEnergy &energy)
  {
    // What the springs gain beyond the trapezoidal work of their forces (eps p at both ends) when eps changes on the
    // way. The round in which it changed does not matter, and a first touch (p = 0) counts nothing: its force goes
    // from zero to the accepted one, whatever the factors of the rounds in between.
    if (normal_springs_ && before.touching && now.touching)
      energy.epsilon += .5 * (now.penalty_factor - before.penalty_factor) * before.penetration() * now.penetration();
    const double first = before.touching ? before.tangential_force : 0.,
                 last = now.touching ? now.tangential_force : 0.;
    const double friction =
      .5 * (first + last) * slip - (stored_by_friction(now, last) - stored_by_friction(before, first));
    energy.friction += friction;
    growth_ += (last - first) * slip;
    friction_work_[point] = friction;
    // The trapezoidal rule lets half of the force of a point that has touched or let go work over the open gap, where
    // it had none.
    if (now.touching != before.touching && std::isfinite(open_gap) && open_gap > 0)
      energy.epsilon += (now.touching ? -.5 * now.force : .5 * before.force) * open_gap;
  }


  void InterfaceAccount::finish(const ContactProjector &projector, InterfaceState &accepted)
  {
    if (!counts_)
      return;
    // The force has changed by the growth somewhere within the increment; the trapezoidal rule has put it in the
    // middle. Where it was is as good as random: the error is evenly spread between half the growth and its negative.
    accepted.energy.friction_variance += growth_ * growth_ / 12.;
    accepted.energy.stored = stored(projector, accepted.points);
  }


  void InterfaceAccount::refresh(const ContactProjector &projector,
                                 const Vector &q,
                                 const Tensor1 &way,
                                 InterfaceState &accepted) const
  {
    if (!counts_)
      return;
    projector.for_near_points([&](const unsigned int i) {
      ContactPointState &state = accepted.points[i];
      if (!state.touching)
        return;
      const ContactPoint point = projector.point(q, i);
      state.offset = point.offset;
      const double gap = projector.look(i, point.x - way).distance - face(point, state);
      // The force works on the face that moves towards the counterpart.
      accepted.energy.thickness += state.force * (state.gap - gap);
    });
  }


  void InterfaceAccount::renew(const ContactProjector &projector, InterfaceState &state) const
  {
    if (!counts_)
      return;
    const double before = state.energy.stored;
    state.energy.stored = stored(projector, state.points);
    state.energy.epsilon += state.energy.stored - before;
  }


  void InterfaceAccount::release(ContactEnergy &energy)
  {
    energy.epsilon -= energy.stored;
    energy.stored = 0.;
  }


  double InterfaceAccount::stored(const ContactProjector &projector, const std::vector<ContactPointState> &points) const
  {
    double sum = 0.;
    projector.for_near_points([&](const unsigned int i) {
      const ContactPointState &state = points[i];
      if (!state.touching)
        return;
      const double p = state.penetration();
      if (normal_springs_)
        sum += .5 * state.penalty_factor * p * p;
      sum += .5 * state.compliance * state.force * state.force;
      if (state.tangential_factor > 0)
        sum += .5 * state.tangential_force * state.tangential_force / state.tangential_factor;
    });
    return sum;
  }
} // namespace deltaform
