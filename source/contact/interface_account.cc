#include <deltaform/contact/contact_measures.h>
#include <deltaform/contact/interface_account.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    double normal_force(const ContactPointState &state)
    {
      return state.touching ? state.force : 0.;
    }

    double tangential_force(const ContactPointState &state)
    {
      return state.touching ? state.tangential_force : 0.;
    }

    /// A length, where it is more than the round-off of a point's gap: else 0.
    double certain(const double length, const ContactPointState &state)
    {
      return std::abs(length) > state.noise ? length : 0.;
    }

    /// What the places of the sheet where the point was when the increment began and where it is at @p q have done
    /// since, relative to the counterpart. The same for a point that stays. @param start where it was then
    std::pair<Tensor1, Tensor1>
    ways(const InterfaceAccount::Increment &increment, const Vector &q, const ContactPoint &start)
    {
      const MovingPoints &moving = increment.projector.moving();
      const Tensor1 of_point = increment.now.position - start.x;
      if (!moving.used())
        return {of_point, of_point};
      ContactPoint now, then;
      const FarEdges &far = increment.projector.far();
      const auto way = [&](const double xi) -> Tensor1 {
        increment.projector.locate(q, increment.point, xi, now);
        increment.projector.locate(far.start(), increment.point, xi, then);
        return (now.x - increment.shift) - (then.x - far.start_shift());
      };
      return {way(moving.accepted(increment.point)), way(moving.place(increment.point))};
    }

    double stored_by_friction(const ContactPointState &state)
    {
      const double t = tangential_force(state);
      return state.touching && state.tangential_factor > 0 ? .5 * t * t / state.tangential_factor : 0.;
    }
  } // namespace


  void InterfaceAccount::begin(const unsigned int n_points)
  {
    friction_work_.assign(counts_ ? n_points : 0, 0.);
    growth_ = 0.;
  }


  void InterfaceAccount::add(const Increment &increment, const Vector &q, ContactEnergy &energy)
  {
    add_friction(increment, energy);
    // The blank, when it was accepted, has put the point and its face elsewhere.
    const ContactProjector &projector = increment.projector;
    const ContactPoint start = projector.start(increment.point);
    const Projection closest = projector.look(increment.point, start.x);
    const Projection end = projector.look(increment.point, increment.now.position);
    // Of the place where the point was, and of that where it is: a point that moves is in another one.
    const auto [first, last] = ways(increment, q, start);
    add_springs(increment, start, closest, end, {first * closest.normal, last * end.normal}, energy);
    add_climbing(increment, q, end, {first * end.tangent, last * end.tangent}, energy);
    add_update(increment, start, closest, energy);
  }


  void InterfaceAccount::add_friction(const Increment &increment, ContactEnergy &energy)
  {
    const double first = tangential_force(increment.before), last = tangential_force(increment.now);
    const double friction = .5 * (first + last) * increment.slip -
                            (stored_by_friction(increment.now) - stored_by_friction(increment.before));
    energy.friction += friction;
    growth_ += (last - first) * increment.slip;
    friction_work_[increment.point] = friction;
  }


  void InterfaceAccount::add_springs(const Increment &increment,
                                     const ContactPoint &start,
                                     const Projection &closest,
                                     const Projection &end,
                                     const std::pair<double, double> &ways,
                                     ContactEnergy &energy) const
  {
    const ContactPointState &before = increment.before, &now = increment.now;
    // eps p at both ends when eps changes on the way. The round in which it changed does not matter, and a first touch
    // (p = 0) counts nothing: its force goes from zero to the accepted one, whatever the factors of the rounds between.
    if (normal_springs_ && before.touching && now.touching)
      energy.epsilon += .5 * (now.penalty_factor - before.penalty_factor) * before.penetration() * now.penetration();
    // The forces at both ends work on the straight way between them, across the counterpart there. What they should
    // have worked on is the change of the gap: along a round tool they would lift the point off it, and where it is
    // free they are not.
    const double gap = before.touching ? closest.distance - start.offset : 0.,
                 change = (now.touching ? end.distance - increment.offset : 0.) - gap;
    energy.epsilon += .5 * (normal_force(before) * certain(ways.first - change, before) +
                            normal_force(now) * certain(ways.second - change, now));
  }


  void InterfaceAccount::add_climbing(const Increment &increment,
                                      const Vector &q,
                                      const Projection &end,
                                      const std::pair<double, double> &ways,
                                      ContactEnergy &energy)
  {
    const ContactPointState &before = increment.before;
    ContactPointState &now = increment.now;
    now.slope = now.touching ? increment.projector.slope(q, increment.point, end) : 0.;
    energy.climbing -= .5 * (normal_force(before) * before.slope * ways.first + normal_force(now) * now.slope * ways.second);
  }


  void InterfaceAccount::add_update(const Increment &increment,
                                    const ContactPoint &start,
                                    const Projection &closest,
                                    ContactEnergy &energy)
  {
    const ContactPointState &before = increment.before, &now = increment.now;
    if (before.touching)
      energy.thickness += .5 * (normal_force(before) + normal_force(now)) *
                          certain(before.gap - (closest.distance - face(start, before)), before);
    if (increment.friction != nullptr)
    {
      const double slip = increment.friction->slip_to(
        increment.point, before, now, {start.x, closest.arc_length}, increment.offset);
      energy.thickness += .5 * (tangential_force(before) + tangential_force(now)) * certain(slip, before);
    }
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
