// A blank that is refined: where contact wants shorter edges, and what new contact nodes take over from old ones.
#include <deltaform/contact/contact_pair.h>

#include <array>
#include <cmath>
#include <limits>

namespace deltaform
{
  void ContactPair::shorten_edges(const double share, const bool rim, std::vector<double> &longest) const
  {
    const auto &edges = surface_.contact_edges(tool_.side());
    longest.resize(edges.size(), std::numeric_limits<double>::infinity());
    const Vector undeformed(surface_.n_contact_dofs());
    for (unsigned int e = 0; e < edges.size(); ++e)
    {
      const unsigned int a = edges[e][0], b = edges[e][1];
      const auto touching = [&](const unsigned int i) { return committed_[i].touching; };
      // A node without area has no pair: on the axis contact does not end.
      if ((rim && area_[a] > 0 && area_[b] > 0 && touching(a) != touching(b)) || missed(edges[e]))
        longest[e] = 0.;
      if (share == 0. || longest[e] == 0.)
        continue;
      // The tool's radius is to be compared with the length that the edge has now; forging stretches it many times.
      const double radius = radius_along(edges[e]);
      if (radius < std::numeric_limits<double>::infinity())
        longest[e] = std::min(longest[e],
                              share * radius * node(undeformed, a).x.distance(node(undeformed, b).x) /
                                committed_x_[a].distance(committed_x_[b]));
    }
  }


  double ContactPair::radius_along(const std::array<unsigned int, 3> &edge) const
  {
    const unsigned int a = edge[0], b = edge[1];
    const Point2 &A = committed_x_[a], &B = committed_x_[b];
    const double length = A.distance(B);
    double radius = std::numeric_limits<double>::infinity();
    const std::array<Projection, 2> feet{{tool_.project(A, 0., hint_[a]), tool_.project(B, 0., hint_[b])}};
    for (const unsigned int k : {0, 1})
    {
      const Projection &foot = feet[k];
      // Twice the height of the arc over the edge: before the nodes come so near, the middle may have touched.
      const double near = .25 * length * length * std::abs(foot.turning);
      if (foot.turning != 0. && (committed_[edge[k]].touching || foot.distance < near))
        radius = std::min(radius, 1. / std::abs(foot.turning));
    }
    // Ends on the straights beside an arc do not see it, nor do those on large arcs beside a small one.
    if (!std::isfinite(feet[0].distance) || !std::isfinite(feet[1].distance))
      return radius;
    const double between = tool_.shape().smallest_radius(feet[0].arc_length, feet[1].arc_length);
    if (!(between < radius))
      return radius;
    const double nearness = .25 * length * std::min(1., length / between);
    bool near = committed_[a].touching && committed_[b].touching;
    constexpr unsigned int n_samples = 8;
    for (unsigned int k = 1; k < n_samples && !near; ++k)
    {
      const Projection foot = tool_.project(A + (k / static_cast<double>(n_samples)) * (B - A), 0.);
      near = foot.turning != 0. && foot.distance < nearness;
    }
    return near ? between : radius;
  }


  bool ContactPair::missed(const std::array<unsigned int, 3> &edge) const
  {
    for (const auto i : edge)
      if (i != invalid_index && committed_[i].touching)
        return false;
    const Point2 &A = committed_x_[edge[0]], &B = committed_x_[edge[1]];
    if (tool_.project(A, 0., hint_[edge[0]]).distance > A.distance(B))
      return false;
    constexpr unsigned int n_samples = 8;
    for (unsigned int k = 0; k <= n_samples; ++k)
      if (tool_.project(A + (k / static_cast<double>(n_samples)) * (B - A), 0.).distance < 0)
        return true;
    return false;
  }


  void ContactPair::resize()
  {
    const unsigned int n = surface_.n_contact_nodes(tool_.side());
    committed_.assign(n, PairState());
    trial_ = committed_;
    committed_residual_.assign(n, {});
    residual_ = committed_residual_;
    area_.assign(n, 0.);
    thickness_of_.assign(n, 0.);
    stiffness_.assign(n, {});
    committed_x_.assign(n, Point2());
    x_.assign(n, Point2());
    projected_x_.assign(n, Point2());
    projected_gap_.assign(n, -1.);
    noise_.assign(n, 0.);
    hint_.assign(n, invalid_index);
    description_.assign(n, ContactNode());
    normal_.assign(n, Tensor1());
    base_multiplier_.assign(n, 0.);
    step_multiplier_.assign(n, 0.);
  }


  void ContactPair::start_multipliers(Vector &q) const
  {
    if (settings_.enforcement->has_multiplier())
      for (unsigned int i = 0; i < committed_.size(); ++i)
        q[first_multiplier_ + i] = committed_[i].touching ? committed_[i].force : 0.;
  }


  void ContactPair::inherit(const Vector &q, const std::vector<std::array<unsigned int, 2>> &heritage)
  {
    const std::vector<PairState> old = committed_;
    const std::vector<double> old_area(area_);
    const std::vector<unsigned int> old_hint(hint_);
    resize();

    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < heritage.size(); ++i)
    {
      // A node without area (axis) has nothing to leave: its neighbour stands for it.
      auto [a, b] = heritage[i];
      if (!(old_area[a] > 0))
        a = b;
      else if (!(old_area[b] > 0))
        b = a;
      const ContactNode description = node(q, i);
      committed_x_[i] = description.x - shift;
      area_[i] = description.area;
      thickness_of_[i] = description.thickness;
      hint_[i] = old_hint[a];
      if (!old[a].touching || !old[b].touching || !(description.area > 0))
        continue;
      // What belongs to an area is interpolated per area, the rest as it is.
      const auto mean = [&](const auto member) { return .5 * (old[a].*member + old[b].*member); };
      const auto by_area = [&](const auto member) {
        double sum = 0., count = 0.;
        for (const auto k : {a, b})
          if (old_area[k] > 0)
          {
            sum += old[k].*member / old_area[k];
            count += 1.;
          }
        return count > 0 ? sum / count * description.area : 0.;
      };
      PairState &state = committed_[i];
      state = old[a];
      state.sticking = old[a].sticking && old[b].sticking;
      for (const auto member : {&PairState::force,
                                &PairState::previous_force,
                                &PairState::multiplier,
                                &PairState::epsilon,
                                &PairState::shift,
                                &PairState::stiffness,
                                &PairState::tangential_force,
                                &PairState::epsilon_tangential})
        state.*member = by_area(member);
      for (const auto member :
           {&PairState::gap, &PairState::last_penetration, &PairState::delta, &PairState::slip_start, &PairState::slip})
        state.*member = mean(member);
      state.arc_length = tool_.project(committed_x_[i], 0., hint_[i]).arc_length;
    }
    trial_ = committed_;
    if (energy_)
    {
      const double stored = energy_->stored;
      update_stored_energy();
      energy_->epsilon += energy_->stored - stored;
    }
  }
} // namespace deltaform
