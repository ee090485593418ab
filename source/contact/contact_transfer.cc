#include "contact_transfer.h"

namespace deltaform
{
  namespace
  {
    /// What a new point between two old ones that touch takes over: what belongs to an area is interpolated per area,
    /// the rest as it is. Forces and factors are those of @p area.
    ContactPointState between(const ContactPointState &a, const ContactPointState &b, const double area)
    {
      const auto mean = [&](const auto member) { return .5 * (a.*member + b.*member); };
      const auto by_area = [&](const auto member) {
        double sum = 0., count = 0.;
        for (const auto *const old : {&a, &b})
          if (old->area > 0)
          {
            sum += old->*member / old->area;
            count += 1.;
          }
        return count > 0 ? sum / count * area : 0.;
      };
      using State = ContactPointState;
      State state = a;
      state.sticking = a.sticking && b.sticking;
      for (const auto member : {&State::force,
                                &State::previous_force,
                                &State::multiplier,
                                &State::penalty_factor,
                                &State::shift,
                                &State::stiffness,
                                &State::tangential_force,
                                &State::tangential_factor})
        state.*member = by_area(member);
      for (const auto member : {&State::gap, &State::last_penetration, &State::delta, &State::slip_start, &State::slip})
        state.*member = mean(member);
      return state;
    }
  } // namespace


  std::vector<ContactPointState> transferred_points(const std::vector<ContactPointState> &old,
                                                    std::vector<std::array<unsigned int, 2>> parents,
                                                    const Tensor1 &shift,
                                                    const Vector &q,
                                                    ContactProjector &projector)
  {
    // A point without area (axis) has nothing to leave: its neighbour stands for it.
    std::vector<unsigned int> first;
    for (auto &[a, b] : parents)
    {
      if (!(old[a].area > 0))
        a = b;
      else if (!(old[b].area > 0))
        b = a;
      first.push_back(a);
    }
    projector.renumber(first);

    std::vector<ContactPointState> points(projector.n_points());
    for (unsigned int i = 0; i < parents.size(); ++i)
    {
      const auto [a, b] = parents[i];
      const ContactPoint description = projector.point(q, i);
      ContactPointState &state = points[i];
      if (old[a].touching && old[b].touching && description.area > 0)
        state = between(old[a], old[b], description.area);
      state.position = description.x - shift;
      state.area = description.area;
      state.thickness = description.thickness;
      state.compliance = description.compliance;
      if (state.touching)
        state.arc_length = projector.look(i, state.position).arc_length;
    }
    return points;
  }
} // namespace deltaform
