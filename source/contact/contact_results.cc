// Accepting an increment: slip, energies, pressures, and the penetration between the nodes.
#include <deltaform/contact/contact_pair.h>

#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * How deep the straight line between two points that project on the same convex arc is at its deepest point. The
     * offset d grows linearly from @p d_a to @p d_b. With the center of the arc as origin the points are a and b, e =
     * b - a, and the depth at a + xi e is d_a - D_a + xi (d_b - d_a) - (rho - rho_a), rho^2 = h^2 + u^2 with the
     * distance h of the center from the line and u along it: largest where u/rho = k = (d_b - d_a)/|e|, u = h k/sqrt(1
     * - k^2).
     */
    double depth_over_arc(const Projection &a, const Projection &b, const double d_a, const double d_b)
    {
      const Tensor1 from = a.normal / a.turning, e = b.normal / b.turning - from;
      const double length = e.norm(), slope = length > 0. ? (d_b - d_a) / length : 1.;
      if (!(std::abs(slope) < 1.))
        return 0.;
      const double u_a = from * e / length, rho_a = 1. / a.turning;
      const double h = std::abs(from[0] * e[1] - from[1] * e[0]) / length;
      const double u = h * slope / std::sqrt((1. - slope) * (1. + slope));
      if (!(u > u_a) || !(u < u_a + length))
        return 0.;
      return d_a - a.distance + slope * (u - u_a) - (std::hypot(h, u) - rho_a);
    }
  } // namespace


  double ContactPair::slip_of_increment(const Vector &q, const unsigned int i) const
  {
    const PairState &state = trial_[i], &before = committed_[i];
    if (state.touching)
      return tool_.shape().slip(
        before.touching ? before.arc_length : state.slip_start, state.arc_length, description_[i].offset);
    // What has let go may be anywhere, also beyond the end of the tool: along the tangent where it was held last.
    const Projection last = tool_.project(committed_x_[i], 0., hint_[i]);
    return slip_share(last, node(q, i).offset) * ((x_[i] - committed_x_[i]) * last.tangent);
  }


  double ContactPair::dissipate(const PairState &before, const PairState &now, const double slip)
  {
    const double first = before.touching ? before.tangential_force : 0.,
                 last = now.touching ? now.tangential_force : 0.;
    const auto stored = [](const PairState &s, const double t) {
      return s.touching && s.epsilon_tangential > 0 ? .5 * t * t / s.epsilon_tangential : 0.;
    };
    energy_->friction += .5 * (first + last) * slip - (stored(now, last) - stored(before, first));
    return (last - first) * slip;
  }


  void ContactPair::commit(const Vector &q)
  {
    double growth = 0.; // of the work of friction over this slip, from the forces at the start to those at the end
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      // The trial states are those of the last assembly.
      Assert(x_[i].distance(node(q, i).x - travel(q) * tool_.direction()) <= 1e-12 * (1. + x_[i].norm()),
             dealii::ExcInternalError());
      PairState &state = trial_[i];
      const PairState &before = committed_[i];
      state.previous_force = before.touching ? before.force : 0.;
      if (!state.touching)
        state.epsilon = state.epsilon_tangential = state.stiffness = state.shift = state.last_penetration = 0.;

      // What the springs gain beyond the trapezoidal work of their forces (eps p at both ends) when eps changes on the
      // way. The round in which it changed does not matter, and a first touch (p = 0) counts nothing: its force goes
      // from zero to the accepted one, whatever the factors of the rounds in between.
      if (energy_ && stores_energy() && before.touching && state.touching)
        energy_->epsilon += .5 * (state.epsilon - before.epsilon) * before.penetration() * state.penetration();
      if (friction_ && (state.touching || (before.touching && energy_)))
      {
        const double slip = slip_of_increment(q, i);
        if (state.touching && !state.sticking)
          state.slip += std::abs(slip);
        if (energy_)
          growth += dissipate(before, state, slip);
      }
    }
    // The force has changed by the growth somewhere within the increment; the trapezoidal rule has put it in the
    // middle. Where it was is as good as random: the error is evenly spread between half the growth and its negative.
    if (energy_)
      energy_->friction_variance += growth * growth / 12.;
    last_step_ = time_ - last_time_;
    last_time_ = time_;
    committed_ = trial_;
    committed_residual_ = residual_;
    committed_x_.swap(x_);
    if (energy_)
      update_stored_energy();
  }


  void ContactPair::update_stored_energy()
  {
    energy_->stored = 0.;
    for (unsigned int i = 0; i < committed_.size(); ++i)
      if (const PairState &state = committed_[i]; state.touching)
      {
        const double p = state.penetration();
        if (stores_energy())
          energy_->stored += .5 * state.epsilon * p * p;
        energy_->stored += .5 * description_[i].squeeze * state.force * state.force;
        if (state.epsilon_tangential > 0)
          energy_->stored += .5 * state.tangential_force * state.tangential_force / state.epsilon_tangential;
      }
  }


  void ContactPair::refresh(const Vector &q)
  {
    if (!energy_)
      return;
    // The thickness has changed at fixed positions; the forces stay those of the accepted equilibrium.
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < committed_.size(); ++i)
    {
      const PairState &state = committed_[i];
      if (!state.touching)
        continue;
      const ContactNode description = node(q, i);
      const double gap = tool_.project(description.x - shift, 0., hint_[i]).distance - face(description, state);
      // The force works on the face that moves towards the tool.
      energy_->thickness += state.force * (state.gap - gap);
    }
  }


  ContactEnergy ContactPair::energy() const
  {
    return energy_.value_or(ContactEnergy());
  }


  std::vector<double> ContactPair::pressure(const Vector &q) const
  {
    std::vector<double> result(committed_.size(), 0.);
    for (unsigned int i = 0; i < result.size(); ++i)
      if (committed_[i].touching)
      {
        const ContactNode description = node(q, i);
        result[i] = description.area > 0 ? committed_[i].force / description.area : 0.;
      }
    return result;
  }


  unsigned int ContactPair::n_touching() const
  {
    unsigned int count = 0;
    for (const auto &state : trial_)
      count += state.touching;
    return count;
  }


  std::vector<ContactPair::Frame> ContactPair::frames() const
  {
    std::vector<Frame> result;
    for (unsigned int i = 0; i < trial_.size(); ++i)
      if (trial_[i].touching)
        result.push_back({description_[i].dofs[0], description_[i].dofs[1], normal_[i]});
    return result;
  }


  double ContactPair::penetration_between_nodes(const Vector &q) const
  {
    const Tensor1 shift = travel(q) * tool_.direction();
    double deepest = 0.;
    unsigned int last_node = invalid_index; // whose projection is
    Projection last{};
    for (const auto &edge : surface_.contact_edges(tool_.side()))
    {
      const unsigned int a = edge[0], b = edge[1], m = edge[2];
      if (!committed_[a].touching && !committed_[b].touching && (m == invalid_index || !committed_[m].touching))
        continue;
      const ContactNode start = node(q, a), end = node(q, b);
      const ContactNode middle = m == invalid_index ? start : node(q, m);
      const double a_face = face(start, committed_[a]), b_face = face(end, committed_[b]);
      const double m_face = m == invalid_index ? 0. : face(middle, committed_[m]);
      const auto gap = [&](const double xi) {
        const std::array<double, 3> N =
          m == invalid_index ? std::array<double, 3>{{1 - xi, xi, 0.}}
                             : std::array<double, 3>{{(1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1), 4 * xi * (1 - xi)}};
        Point2 x = start.x - shift;
        const double offset = N[0] * a_face + N[1] * b_face + N[2] * m_face;
        x += N[1] * (end.x - start.x) + N[2] * (middle.x - start.x);
        return tool_.project(x, 0., hint_[a]).distance - offset;
      };
      const Projection first = last_node == a ? last : tool_.project(start.x - shift, 0., hint_[a]);
      last = tool_.project(end.x - shift, 0., hint_[a]);
      last_node = b;
      deepest = std::max({deepest, a_face - first.distance, b_face - last.distance});
      // A straight edge over one part of the tool that is straight or hollow is deepest at one of its ends.
      if (m == invalid_index && first.segment == last.segment && (start.x[0] < 0) == (end.x[0] < 0))
      {
        if (first.turning > 0. && last.turning > 0.)
          deepest = std::max(deepest, depth_over_arc(first, last, a_face, b_face));
        continue;
      }
      // Two humps are possible where a line meets an arc inside the element: search both halves.
      for (const double low : {0., .5})
        deepest = std::max(deepest, -boost::math::tools::brent_find_minima(gap, low, low + .5, 20).second);
    }
    return deepest;
  }


  std::pair<unsigned int, double> ContactPair::closest(const Vector &q, const double travel) const
  {
    std::pair<unsigned int, double> result(invalid_index, std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < committed_.size(); ++i)
    {
      const ContactNode description = node(q, i);
      if (!(description.area > 0))
        continue;
      const double gap = tool_.project(description.x, travel).distance - description.offset;
      if (gap < result.second)
        result = {i, gap};
    }
    return result;
  }


  void ContactPair::release(const Vector &q, AssemblyTarget &target)
  {
    for (unsigned int i = 0; i < committed_.size(); ++i)
      if (committed_[i].touching)
      {
        const ContactNode description = node(q, i);
        target.add(description.dofs.data(), description.n_dofs, nullptr, committed_residual_[i].data());
      }
    for (auto &state : committed_)
      state = PairState();
    trial_ = committed_;
    // The springs leave with the tool, and what they hold.
    if (energy_)
    {
      energy_->epsilon -= energy_->stored;
      energy_->stored = 0.;
    }
  }


  void ContactPair::forget_energy()
  {
    energy_.reset();
  }
} // namespace deltaform
