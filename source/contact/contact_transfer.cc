// A blank with other nodes, or a tool that leaves: what becomes of the contact points.
#include "interface_energy.h"

#include <deltaform/contact/contact_interface.h>

#include <array>

namespace deltaform
{
  namespace
  {
    /// What a new node between two old ones that touch takes over: what belongs to an area is interpolated per area,
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


  void ContactInterface::resize()
  {
    committed_.points.assign(n_nodes(), ContactPointState());
    trial_.points = committed_.points;
    work_.assign(n_nodes(), Work());
    projector_.reset();
  }


  void ContactInterface::start_multipliers(Vector &q) const
  {
    if (settings_.enforcement->has_multiplier())
      for (unsigned int i = 0; i < committed_.points.size(); ++i)
        q[first_multiplier_ + i] = committed_.points[i].touching ? committed_.points[i].force : 0.;
  }


  void ContactInterface::transfer(const Vector &q, const std::vector<std::array<unsigned int, 2>> &parent_nodes)
  {
    const std::vector<ContactPointState> old = committed_.points;
    std::vector<ContactPointState> &points = committed_.points;
    points.assign(n_nodes(), ContactPointState());
    work_.assign(n_nodes(), Work());

    // A node without area (axis) has nothing to leave: its neighbour stands for it.
    std::vector<std::array<unsigned int, 2>> parents(parent_nodes);
    std::vector<unsigned int> first;
    for (auto &[a, b] : parents)
    {
      if (!(old[a].area > 0))
        a = b;
      else if (!(old[b].area > 0))
        b = a;
      first.push_back(a);
    }
    projector_.renumber(first);

    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < parents.size(); ++i)
    {
      const auto [a, b] = parents[i];
      const ContactNode description = node(q, i);
      ContactPointState &state = points[i];
      if (old[a].touching && old[b].touching && description.area > 0)
        state = between(old[a], old[b], description.area);
      state.position = description.x - shift;
      state.area = description.area;
      state.thickness = description.thickness;
      state.compliance = description.compliance;
      if (state.touching)
        state.arc_length = projector_.look(i, state.position).arc_length;
    }
    if (counts_energy_)
    {
      const double stored = committed_.energy.stored;
      committed_.energy.stored = stored_energy(points, settings_.stores_energy());
      committed_.energy.epsilon += committed_.energy.stored - stored;
    }
    const double time = trial_.time;
    trial_ = committed_;
    trial_.time = time;
  }


  void ContactInterface::release(const Vector &q, AssemblyTarget &target)
  {
    for (unsigned int i = 0; i < committed_.points.size(); ++i)
    {
      ContactPointState &state = committed_.points[i];
      if (state.touching)
      {
        const ContactNode description = node(q, i);
        target.add(description.dofs.data(), description.n_dofs, nullptr, state.residual.data());
      }
      state.release();
    }
    trial_.points = committed_.points;
    // The springs leave with the tool, and what they hold.
    committed_.energy.epsilon -= committed_.energy.stored;
    committed_.energy.stored = 0.;
  }
} // namespace deltaform
