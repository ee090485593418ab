// Penalty factors of the pairs: when they are predicted, corrected, and what they have to do with the promise.
#include <deltaform/contact/contact_pair.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  void ContactPair::read_stiffness(const Vector &q, const StiffnessView &stiffness)
  {
    ContactNode node;
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      describe(q, i, node);
      stiffness.block(node.dofs.data(), node.n_dofs, stiffness_[i].data());
      // Pairs that touch set their stiffness anew below; the others when they touch for the first time.
      trial_[i].stiffness = 0.;
    }
  }


  double ContactPair::nodal_stiffness(const unsigned int i, const ContactNode &node, const Tensor1 &direction) const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < node.n_dofs; ++k)
      for (unsigned int l = 0; l < node.n_dofs; ++l)
        sum += (node.jacobian[k] * direction) * stiffness_[i][k * node.n_dofs + l] * (node.jacobian[l] * direction);
    return std::max(sum, std::numeric_limits<double>::min());
  }


  double ContactPair::neighbour_factor(const unsigned int i) const
  {
    double factor = median_factor_;
    for (const unsigned int j : {i - 1, i + 1}) // i - 1 wraps around to a number that is too large
      if (j < trial_.size() && trial_[j].touching)
        factor = std::max(factor, trial_[j].epsilon);
    return factor;
  }


  PenaltyInput ContactPair::input(const unsigned int i, const PairState &state, const double coupling) const
  {
    PenaltyInput result;
    result.force = state.force;
    result.penetration = state.penetration();
    result.previous_penetration = state.last_penetration;
    result.previous_epsilon = state.epsilon;
    result.stiffness = state.stiffness;
    result.coupling = coupling;
    result.area = area_[i];
    result.thickness = thickness_of_[i];
    result.modulus = surface_.modulus();
    result.delta = state.delta;
    result.neighbour = neighbour_factor(i);
    return result;
  }


  double ContactPair::expected_growth(const unsigned int i) const
  {
    const PairState &state = committed_[i];
    if (!(last_step_ > 0))
      return 0.;
    return std::clamp((state.force - state.previous_force) * (time_ - last_time_) / last_step_, 0., state.force);
  }


  FrictionInput ContactPair::friction_input(const unsigned int i, const double normal_force) const
  {
    FrictionInput result;
    result.normal_force = normal_force;
    result.committed = committed_[i].touching ? committed_[i].tangential_force : 0.;
    result.stiffness = trial_[i].epsilon_tangential;
    result.area = area_[i];
    if (!flow_stress_.empty())
      result.flow_stress = flow_stress_[i];
    return result;
  }


  double ContactPair::tangential_factor(const unsigned int i, const double stiffness) const
  {
    if (settings_.tangential_factor > 0)
      return settings_.tangential_factor;
    const double limit = friction_->limit(friction_input(i, trial_[i].force)).value;
    return std::max(settings_.tangential_floor * stiffness, limit / slip_limit_);
  }


  void ContactPair::touch(const unsigned int i, const ContactNode &node, const Projection &projection)
  {
    PairState &state = trial_[i];
    state.stiffness = nodal_stiffness(i, node, projection.normal);
    if (settings_.enforcement->uses_penalty() && state.epsilon == 0)
      state.epsilon = settings_.rule->predict(input(i, state, 0.));
    if (friction_)
    {
      state.epsilon_tangential =
        std::max(state.epsilon_tangential, tangential_factor(i, nodal_stiffness(i, node, projection.tangent)));
      if (!committed_[i].touching)
        state.slip_start = tool_.project(committed_x_[i], 0., hint_[i]).arc_length;
    }
  }


  void ContactPair::add_mismatch(const Vector &q, Vector &direction) const
  {
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < trial_.size(); ++i)
      if (trial_[i].touching)
      {
        const ContactNode description = node(q, i);
        const Projection projection = tool_.project(description.x - shift, 0., hint_[i]);
        // C points into the tool
        for (unsigned int k = 0; k < description.n_dofs; ++k)
          direction[description.dofs[k]] -=
            (description.jacobian[k] * projection.normal) * (trial_[i].penetration() - trial_[i].delta);
      }
  }


  void ContactPair::predict_factors(const Vector &q, const Vector *coupling)
  {
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      PairState &state = trial_[i];
      if (!state.touching)
      {
        if (!committed_[i].touching)
          state.epsilon = state.epsilon_tangential = 0.;
        continue;
      }
      const ContactNode description = node(q, i);
      const Projection projection = tool_.project(description.x - shift, 0., hint_[i]);
      state.stiffness = nodal_stiffness(i, description, projection.normal);
      area_[i] = description.area;
      thickness_of_[i] = description.thickness;
      double product = 0.;
      if (coupling)
        for (unsigned int k = 0; k < description.n_dofs; ++k)
          product -= (description.jacobian[k] * projection.normal) * (*coupling)[description.dofs[k]];
      if (settings_.enforcement->uses_penalty())
      {
        PenaltyInput what = input(i, state, product);
        what.force += expected_growth(i);
        state.epsilon = settings_.rule->predict(what);
      }
      if (friction_)
        state.epsilon_tangential = tangential_factor(i, nodal_stiffness(i, description, projection.tangent));
      state.last_penetration = state.penetration();
      state.shift = settings_.enforcement->start_shift(state);
    }
  }


  unsigned int ContactPair::correct_factors()
  {
    if (softening_ < 1)
    {
      softening_ = softening_ < .05 ? 10. * softening_ : 1.;
      return 1;
    }
    if (!settings_.enforcement->uses_penalty())
      return 0;
    const bool augmented = !stores_energy();
    unsigned int changed = 0;
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      PairState &state = trial_[i];
      if (!state.touching)
        continue;
      PenaltyInput what = input(i, state, 0.);
      if (what.penetration <= state.delta + tolerance(i))
        what.penetration = std::min(what.penetration, state.delta);
      // Augmentation takes the penetration away, and leaves the factor as soft as it is.
      bool change = false;
      if (!augmented)
      {
        const double epsilon = settings_.rule->correct(what);
        change = epsilon != state.epsilon;
        state.epsilon = epsilon;
        state.last_penetration = state.penetration();
      }
      if (friction_ && settings_.tangential_factor == 0 && state.sticking)
      {
        const double creep = std::abs(state.tangential_force) / state.epsilon_tangential;
        if (creep > slip_limit_ * (1 + 1e-6))
        {
          state.epsilon_tangential *= std::min(10., creep / (.8 * slip_limit_));
          change = true;
        }
      }
      changed += change;
    }
    return changed;
  }


  double ContactPair::automatic_delta() const
  {
    // A straight element cuts a curved tool by h^2 k/8, a quadratic one misses the change of the curvature, about h^2
    // dk/(72 sqrt 3), and of a circle the fourth order: h^4 k^3/512. A twentieth of the largest such error under the
    // tool, so that contact is never what the result suffers from.
    const auto project = [&](const unsigned int i) { return tool_.project(committed_x_[i], 0., hint_[i]); };
    std::vector<bool> concerned(committed_.size());
    bool any = false;
    double thickness = 0.;
    for (unsigned int i = 0; i < committed_.size(); ++i)
    {
      concerned[i] = committed_[i].touching;
      any |= concerned[i];
      thickness = std::max(thickness, thickness_of_[i]);
    }
    if (!any)
    {
      // Nothing touches yet: where it will.
      unsigned int closest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (unsigned int i = 0; i < committed_.size(); ++i)
        if (const double distance = project(i).distance; distance < least)
        {
          least = distance;
          closest = i;
        }
      concerned[closest] = true;
    }
    double error = 0.;
    for (const auto &edge : surface_.contact_edges(tool_.side()))
    {
      const unsigned int a = edge[0], b = edge[1], m = edge[2];
      if (!concerned[a] && !concerned[b] && (m == invalid_index || !concerned[m]))
        continue;
      const double square = (committed_x_[b] - committed_x_[a]).norm_square();
      const double ka = project(a).turning, kb = project(b).turning, k = std::max(std::abs(ka), std::abs(kb));
      error = std::max(error,
                       square * (edge[2] == invalid_index
                                   ? k / 8.
                                   : std::abs(ka - kb) / (72. * std::sqrt(3.)) + square * k * k * k / 512.));
    }
    return error > 0 ? std::clamp(.05 * error, 1e-6 * thickness, 1e-2 * thickness) : 1e-3 * thickness;
  }


  double ContactPair::tolerance(const unsigned int i) const
  {
    return std::max(1e-6 * trial_[i].delta, noise_[i]);
  }


  bool
  ContactPair::augmentation(std::vector<double> &shifts, std::vector<double> &forces, const double relaxation) const
  {
    const double allowed = std::min(1., relaxation * settings_.enforcement->augmentation_tolerance());
    bool exact = true;
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      const PairState &state = trial_[i];
      const double force = state.touching ? std::max(state.force, 0.) : 0.;
      shifts.push_back(state.shift);
      forces.push_back(force);
      const double gap = force > 0 ? std::abs(state.gap) : std::max(-state.gap, 0.);
      exact &= !state.touching || gap <= std::max(allowed * state.delta, noise_[i]);
    }
    return exact;
  }


  const double *ContactPair::shift(const double *next)
  {
    for (auto &state : trial_)
      state.shift = *next++;
    return next;
  }


  std::pair<unsigned int, double> ContactPair::broken_promise() const
  {
    std::pair<unsigned int, double> worst(invalid_index, 0.);
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      const double excess = trial_[i].penetration() - trial_[i].delta - tolerance(i);
      if (trial_[i].touching && excess > 0 && trial_[i].penetration() / trial_[i].delta > worst.second)
        worst = {i, trial_[i].penetration() / trial_[i].delta};
    }
    return worst;
  }


  bool ContactPair::governed_by_floor(const unsigned int i) const
  {
    const PenaltyInput what = input(i, committed_[i], 0.);
    const double floor = settings_.rule->floor(what);
    return floor > 0 && committed_[i].epsilon <= floor * (1 + 1e-9);
  }
} // namespace deltaform
