// Who is in contact: what a step makes of the forces, which states are solutions, what is too little to matter.
#include <deltaform/contact/contact_interface.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  bool ContactInterface::is_idle(const ContactPointState &state, const double gap) const
  {
    return std::abs(state.multiplier) <= slack_ && std::abs(state.shift - state.penalty_factor * gap) <= slack_ &&
           gap >= -state.delta;
  }


  NormalResponse ContactInterface::respond(const unsigned int i, const double gap) const
  {
    const ContactPointState &state = trial_.points[i];
    const bool is_multiplier = settings_.enforcement->has_multiplier();
    if (!std::isfinite(gap))
      return {};
    // The gap at the start is wrong by what extrapolation leaves out, and an equilibrium that hangs on a few nodes is
    // lost if one of them lets go for that: the step then goes where nothing holds the blank.
    if (at_start_ && committed_.points[i].touching && state.multiplier > 0)
      return is_multiplier ? settings_.enforcement->respond(state, std::min(gap, 0.), state.multiplier)
                           : settings_.enforcement->respond(state, gap, std::numeric_limits<double>::infinity());
    const NormalResponse normal = settings_.enforcement->respond(state, gap, state.multiplier);
    if (slack_ > 0 && normal.touching != state.touching && !is_multiplier && is_idle(state, gap))
      return state.touching
               ? NormalResponse{true, state.shift - state.penalty_factor * gap, -state.penalty_factor, false}
               : NormalResponse();
    return normal;
  }


  void ContactInterface::prepare_step(const Vector &d)
  {
    at_start_ = false;
    if (settings_.enforcement->has_multiplier())
      return;
    const Tensor1 tool_step = tool_.force_driven() ? d[travel_dof_] * tool_.direction() : Tensor1();
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      const ContactPointState &state = trial_.points[i];
      Work &work = work_[i];
      work.base_multiplier = state.multiplier;
      work.step_multiplier = -state.multiplier;
      if (!state.touching)
        continue;
      Tensor1 dx = -tool_step;
      for (unsigned int k = 0; k < work.node.n_dofs; ++k)
        dx += d[work.node.dofs[k]] * work.node.jacobian[k];
      const double factor = factors_.share(committed_.points[i]) * state.penalty_factor;
      const double share = state.spring_share(state.compliance);
      work.step_multiplier += state.shift - factor * (state.gap + share * (work.normal * dx));
    }
  }


  void ContactInterface::advance(const double factor)
  {
    if (!settings_.enforcement->has_multiplier())
      for (unsigned int i = 0; i < trial_.points.size(); ++i)
        trial_.points[i].multiplier = work_[i].base_multiplier + factor * work_[i].step_multiplier;
  }


  double ContactInterface::free_travel() const
  {
    double closest = std::numeric_limits<double>::infinity();
    for (const auto &state : trial_.points)
    {
      if (state.touching)
        return 0.;
      // A node on the axis has no area and no contact. Half of delta beyond the gap: only a penetration makes contact.
      if (state.area > 0)
        closest = std::min(closest, std::max(state.gap, 0.) + .5 * state.delta);
    }
    return closest;
  }


  bool ContactInterface::consistent(const double allowed_tension) const
  {
    // An exact constraint is to be exact: its residual is a length that the forces hardly notice.
    const bool exact = settings_.enforcement->has_multiplier() && !factors_.softened();
    return std::none_of(trial_.points.begin(), trial_.points.end(), [&](const ContactPointState &state) {
      if (!state.touching)
        return false;
      if (exact && std::abs(state.gap) > 1e-8 * state.thickness + state.tolerance())
        return true;
      return state.force < -std::max(allowed_tension, Enforcement::weight(state) * state.tolerance());
    });
  }


  bool ContactInterface::augmentation(std::vector<double> &shifts,
                                      std::vector<double> &forces,
                                      const double relaxation) const
  {
    const double allowed = std::min(1., relaxation * settings_.enforcement->augmentation_tolerance());
    bool exact = true;
    for (const auto &state : trial_.points)
    {
      const double force = state.touching ? std::max(state.force, 0.) : 0.;
      shifts.push_back(state.shift);
      forces.push_back(force);
      const double gap = force > 0 ? std::abs(state.gap) : std::max(-state.gap, 0.);
      exact &= !state.touching || gap <= std::max(allowed * state.delta, state.noise);
    }
    return exact;
  }


  const double *ContactInterface::shift(const double *next)
  {
    for (auto &state : trial_.points)
      state.shift = *next++;
    return next;
  }


  std::vector<ContactInterface::Frame> ContactInterface::frames() const
  {
    std::vector<Frame> result;
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
      if (trial_.points[i].touching)
        result.push_back({work_[i].node.dofs[0], work_[i].node.dofs[1], work_[i].normal});
    return result;
  }
} // namespace deltaform
