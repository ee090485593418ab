#include <deltaform/contact/interface_friction.h>

#include <algorithm>

namespace deltaform
{
  void InterfaceFriction::begin_increment(const ContactSurface &surface, const Side side)
  {
    if (law_->needs_flow_stress())
      flow_stress_ = surface.flow_stress(side);
  }


  FrictionInput InterfaceFriction::input(const unsigned int i,
                                         const ContactPointState &before,
                                         const ContactPointState &now,
                                         const double normal_force) const
  {
    FrictionInput result;
    result.normal_force = normal_force;
    result.committed = before.touching ? before.tangential_force : 0.;
    result.stiffness = now.tangential_factor;
    result.area = now.area;
    result.slip = before.slip;
    if (!flow_stress_.empty())
      result.flow_stress = flow_stress_[i];
    return result;
  }


  FrictionResponse InterfaceFriction::respond(const unsigned int i,
                                              const ContactPointState &before,
                                              const ContactPointState &now,
                                              const double slip_increment,
                                              const double normal_force) const
  {
    // The limit belongs to the estimate of lambda; what the iterate's force differs from it enters linearly.
    FrictionInput what = input(i, before, now, std::max(now.multiplier, 0.));
    what.slip_increment = slip_increment;
    FrictionResponse result = law_->update(what);
    result.force += result.force_rate * (normal_force - what.normal_force);
    return result;
  }
} // namespace deltaform
