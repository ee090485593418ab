#include <deltaform/contact/factor_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  FactorControl::FactorControl(const ContactSettings &settings,
                               const ContactProjector &projector,
                               const InterfaceFriction *friction)
    : settings_(settings), projector_(projector), friction_(friction)
  {
  }


  void FactorControl::begin_increment(const double time, const InterfaceState &committed)
  {
    softening_ = 1.;
    slip_limit_ = settings_.allowed_slip(time);
    step_ = time - committed.time;
    last_step_ = committed.step;
    std::vector<double> factors;
    projector_.for_near_points([&](const unsigned int i) {
      if (const ContactPointState &state = committed.points[i]; state.touching && state.penalty_factor > 0)
        factors.push_back(state.penalty_factor);
    });
    median_ = 0.;
    if (factors.empty())
      return;
    const auto middle = factors.begin() + factors.size() / 2;
    std::nth_element(factors.begin(), middle, factors.end());
    median_ = *middle;
  }


  void FactorControl::read_stiffness(const Vector &q, const StiffnessView &stiffness, Points &trial)
  {
    ContactPoint point;
    const unsigned int n = projector_.group();
    blocks_.resize(trial.size() / n);
    for (unsigned int e = 0; e < blocks_.size(); ++e)
    {
      projector_.describe(q, e * n, point);
      blocks_[e].dofs = point.dofs;
      stiffness.block(point.dofs.data(), point.n_dofs, blocks_[e].values.data());
    }
    // Touching points set their stiffness anew when factors are predicted; the others at their first touch.
    projector_.for_near_points([&](const unsigned int i) { trial[i].stiffness = 0.; });
  }


  void FactorControl::add_mismatch(const Vector &q, const Tensor1 &shift, const Points &trial, Vector &direction) const
  {
    projector_.for_near_points([&](const unsigned int i) {
      const ContactPointState &state = trial[i];
      if (!state.touching)
        return;
      const ContactPoint point = projector_.point(q, i);
      const Projection projection = projector_.look(i, point.x - shift);
      // C points into the tool
      for (unsigned int k = 0; k < point.n_dofs; ++k)
        direction[point.dofs[k]] -= (point.jacobian[k] * projection.normal) * (state.penetration() - state.delta);
    });
  }


  void FactorControl::predict(const Vector &q,
                              const Tensor1 &shift,
                              const Vector *coupling,
                              const Points &committed,
                              Points &trial) const
  {
    projector_.for_near_points([&](const unsigned int i) {
      ContactPointState &state = trial[i];
      if (!state.touching)
      {
        if (!committed[i].touching)
          state.penalty_factor = state.tangential_factor = 0.;
        return;
      }
      const ContactPoint point = projector_.point(q, i);
      const Projection projection = projector_.look(i, point.x - shift);
      state.area = point.area;
      state.thickness = point.thickness;
      double product = 0.;
      if (coupling)
        for (unsigned int k = 0; k < point.n_dofs; ++k)
          product -= (point.jacobian[k] * projection.normal) * (*coupling)[point.dofs[k]];
      predict(i, point, projection, product, committed, trial);
    });
  }


  double FactorControl::point_stiffness(const unsigned int i, const ContactPoint &point, const Tensor1 &direction) const
  {
    const Block &block = blocks_[i / projector_.group()];
    const unsigned int n = point.n_dofs;
    // The points of an edge name its unknowns in orders of their own.
    std::array<double, ContactPoint::max_dofs> row{};
    for (unsigned int k = 0; k < n; ++k)
      row[std::find(block.dofs.begin(), block.dofs.begin() + n, point.dofs[k]) - block.dofs.begin()] =
        point.jacobian[k] * direction;
    double sum = 0.;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < n; ++l)
        sum += row[k] * block.values[k * n + l] * row[l];
    return std::max(sum, std::numeric_limits<double>::min());
  }


  PenaltyInput FactorControl::input(const unsigned int i, const Points &points, const double coupling) const
  {
    const ContactPointState &state = points[i];
    PenaltyInput result;
    result.force = state.force;
    result.penetration = state.penetration();
    result.previous_penetration = state.last_penetration;
    result.previous_factor = state.penalty_factor;
    result.stiffness = state.stiffness;
    result.coupling = coupling;
    result.area = state.area;
    result.thickness = state.thickness;
    result.modulus = projector_.surface().modulus();
    result.delta = state.delta;
    result.shares_unknowns = projector_.group() > 1;
    result.neighbour = median_;
    for (const unsigned int j : {i - 1, i + 1}) // i - 1 wraps around to a number that is too large
      if (j < points.size() && points[j].touching)
        result.neighbour = std::max(result.neighbour, points[j].penalty_factor);
    return result;
  }


  double FactorControl::expected_growth(const ContactPointState &before) const
  {
    if (!(last_step_ > 0))
      return 0.;
    return std::clamp((before.force - before.previous_force) * step_ / last_step_, 0., before.force);
  }


  double FactorControl::tangential_factor(const unsigned int i,
                                          const ContactPointState &before,
                                          const ContactPointState &now,
                                          const double stiffness) const
  {
    if (settings_.tangential_factor > 0)
      return settings_.tangential_factor;
    const double limit = friction_->limit(i, before, now, now.force);
    return std::max(settings_.tangential_floor * stiffness, limit / slip_limit_);
  }


  void FactorControl::touch(const unsigned int i,
                            const ContactPoint &point,
                            const Projection &projection,
                            const Points &committed,
                            Points &trial) const
  {
    ContactPointState &state = trial[i];
    state.stiffness = point_stiffness(i, point, projection.normal);
    if (settings_.normal_law->uses_penalty() && state.penalty_factor == 0)
      state.penalty_factor = settings_.rule->predict(input(i, trial, 0.));
    if (friction_)
      state.tangential_factor =
        std::max(state.tangential_factor,
                 tangential_factor(i, committed[i], state, point_stiffness(i, point, projection.tangent)));
  }


  void FactorControl::predict(const unsigned int i,
                              const ContactPoint &point,
                              const Projection &projection,
                              const double coupling,
                              const Points &committed,
                              Points &trial) const
  {
    ContactPointState &state = trial[i];
    state.stiffness = point_stiffness(i, point, projection.normal);
    if (settings_.normal_law->uses_penalty())
    {
      PenaltyInput what = input(i, trial, coupling);
      what.force += expected_growth(committed[i]);
      state.penalty_factor = settings_.rule->predict(what);
    }
    if (friction_)
      state.tangential_factor =
        tangential_factor(i, committed[i], state, point_stiffness(i, point, projection.tangent));
    state.last_penetration = state.penetration();
    state.shift = settings_.normal_law->start_shift(state);
  }


  bool FactorControl::correct_tangential(ContactPointState &state) const
  {
    if (!friction_ || settings_.tangential_factor != 0 || !state.sticking)
      return false;
    const double creep = std::abs(state.tangential_force) / state.tangential_factor;
    if (!(creep > slip_limit_ * (1 + 1e-6)))
      return false;
    state.tangential_factor *= std::min(10., creep / (.8 * slip_limit_));
    return true;
  }


  bool FactorControl::correct_normal(const unsigned int i, Points &trial) const
  {
    ContactPointState &state = trial[i];
    PenaltyInput what = input(i, trial, 0.);
    if (what.penetration <= state.delta + state.tolerance())
      what.penetration = std::min(what.penetration, state.delta);
    const double factor = settings_.rule->correct(what);
    const bool changed = factor != state.penalty_factor;
    state.penalty_factor = factor;
    state.last_penetration = state.penetration();
    return changed;
  }


  bool FactorControl::correct(const unsigned int i, const bool normal, Points &trial) const
  {
    if (!trial[i].touching)
      return false;
    const bool other = normal && correct_normal(i, trial);
    return correct_tangential(trial[i]) || other;
  }


  unsigned int FactorControl::correct_early(const std::vector<unsigned int> &touching, Points &trial) const
  {
    // Of a softened force, and of one that augmentation takes over, the penetration is not the last word.
    if (softening_ < 1 || !settings_.normal_law->uses_penalty() || !settings_.stores_energy())
      return 0;
    unsigned int changed = 0;
    for (const unsigned int i : touching)
      changed += correct(i, settings_.rule->promises(), trial);
    return changed;
  }


  unsigned int FactorControl::correct(Points &trial)
  {
    if (softening_ < 1)
    {
      softening_ = softening_ < .05 ? 10. * softening_ : 1.;
      return 1;
    }
    if (!settings_.normal_law->uses_penalty())
      return 0;
    // Augmentation takes the penetration away, and leaves the factor as soft as it is.
    unsigned int changed = 0;
    projector_.for_near_points(
      [&](const unsigned int i) { changed += correct(i, settings_.stores_energy(), trial); });
    return changed;
  }


  bool FactorControl::governed_by_floor(const unsigned int i, const Points &points) const
  {
    const double floor = settings_.rule->floor(input(i, points, 0.));
    return floor > 0 && points[i].penalty_factor <= floor * (1 + 1e-9);
  }


  std::pair<unsigned int, double> FactorControl::broken_promise(const Points &points)
  {
    std::pair<unsigned int, double> worst(invalid_index, 0.);
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const ContactPointState &state = points[i];
      const double p = state.penetration();
      if (state.touching && p - state.delta - state.tolerance() > 0 && p / state.delta > worst.second)
        worst = {i, p / state.delta};
    }
    return worst;
  }
} // namespace deltaform
