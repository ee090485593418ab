// Who is in contact: what a step makes of the forces, which states are solutions, what is too little to matter.
#include <deltaform/contact/contact_pair.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  bool ContactPair::is_idle(const PairState &state, const double gap) const
  {
    return std::abs(state.multiplier) <= slack_ && std::abs(state.shift - state.epsilon * gap) <= slack_ &&
           gap >= -state.delta;
  }


  NormalResponse ContactPair::respond(const unsigned int i, const double gap) const
  {
    const PairState &state = trial_[i];
    const bool is_multiplier = settings_.enforcement->has_multiplier();
    if (!std::isfinite(gap))
      return {};
    // The gap at the start is wrong by what extrapolation leaves out, and an equilibrium that hangs on a few nodes is
    // lost if one of them lets go for that: the step then goes where nothing holds the blank.
    if (at_start_ && committed_[i].touching && state.multiplier > 0)
      return is_multiplier ? settings_.enforcement->respond(state, std::min(gap, 0.), state.multiplier)
                           : settings_.enforcement->respond(state, gap, std::numeric_limits<double>::infinity());
    const NormalResponse normal = settings_.enforcement->respond(state, gap, state.multiplier);
    if (slack_ > 0 && normal.touching != state.touching && !is_multiplier && is_idle(state, gap))
      return state.touching ? NormalResponse{true, state.shift - state.epsilon * gap, -state.epsilon, false}
                            : NormalResponse();
    return normal;
  }


  void ContactPair::prepare_step(const Vector &d)
  {
    at_start_ = false;
    if (settings_.enforcement->has_multiplier())
      return;
    const Tensor1 tool_step = tool_.force_driven() ? d[travel_dof_] * tool_.direction() : Tensor1();
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      PairState &state = trial_[i];
      base_multiplier_[i] = state.multiplier;
      step_multiplier_[i] = -state.multiplier;
      if (!state.touching)
        continue;
      Tensor1 dx = -tool_step;
      for (unsigned int k = 0; k < description_[i].n_dofs; ++k)
        dx += d[description_[i].dofs[k]] * description_[i].jacobian[k];
      const double epsilon = softening_ < 1 && !committed_[i].touching ? softening_ * state.epsilon : state.epsilon;
      const double share = spring_share(state, description_[i].squeeze);
      step_multiplier_[i] += state.shift - epsilon * (state.gap + share * (normal_[i] * dx));
    }
  }


  void ContactPair::advance(const double factor)
  {
    if (!settings_.enforcement->has_multiplier())
      for (unsigned int i = 0; i < trial_.size(); ++i)
        trial_[i].multiplier = base_multiplier_[i] + factor * step_multiplier_[i];
  }


  double ContactPair::free_travel() const
  {
    double closest = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < trial_.size(); ++i)
    {
      if (trial_[i].touching)
        return 0.;
      // A node on the axis has no area and no pair. Half of delta beyond the gap: only a penetration makes contact.
      if (area_[i] > 0)
        closest = std::min(closest, std::max(trial_[i].gap, 0.) + .5 * trial_[i].delta);
    }
    return closest;
  }


  bool ContactPair::consistent(const double allowed_tension) const
  {
    // An exact constraint is to be exact: its residual is a length that the forces hardly notice.
    if (settings_.enforcement->has_multiplier() && softening_ == 1.)
      for (unsigned int i = 0; i < trial_.size(); ++i)
        if (trial_[i].touching && std::abs(trial_[i].gap) > 1e-8 * description_[i].thickness + tolerance(i))
          return false;
    for (unsigned int i = 0; i < trial_.size(); ++i)
      if (trial_[i].touching &&
          trial_[i].force < -std::max(allowed_tension, Enforcement::weight(trial_[i]) * tolerance(i)))
        return false;
    return true;
  }
} // namespace deltaform
