#include "slip_transfer.h"

#include <deltaform/contact/interface_friction.h>
#include <deltaform/geometry/curvature.h>

#include <algorithm>

namespace deltaform
{
  void InterfaceFriction::resize(const unsigned int n_points)
  {
    if (projector_.group() > 1 && law_->depends_on_pressure())
      mean_pressure_.assign(n_points / projector_.group(), MeanPressure());
  }


  void InterfaceFriction::begin_increment(const std::vector<ContactPointState> &points)
  {
    for (unsigned int e = 0; e < mean_pressure_.size(); ++e)
      look_at(e, points, 1);
  }


  void InterfaceFriction::look_at(const unsigned int e,
                                  const std::vector<ContactPointState> &points,
                                  const unsigned int stride)
  {
    const unsigned int group = projector_.group();
    mean_pressure_[e] = MeanPressure(points, e * group, (e + 1) * group, stride);
  }


  void
  InterfaceFriction::start_slip(const unsigned int i, const ContactPointState &before, ContactPointState &now) const
  {
    if (!before.touching)
      now.slip_start = projector_.look(i, before.position).arc_length;
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
    if (shares())
      if (const double of_mean = mean_pressure(i).value * now.area; of_mean > 0.)
      {
        result.share = normal_force / of_mean;
        result.normal_force = of_mean;
      }
    if (law_->needs_flow_stress())
      result.flow_stress = projector_.surface().flow_stress(projector_.side(), i);
    return result;
  }


  FrictionResponse InterfaceFriction::respond(const unsigned int i,
                                              const ContactPointState &before,
                                              const ContactPointState &now,
                                              const Projection &closest,
                                              const double offset,
                                              const NormalResponse &normal) const
  {
    // The limit belongs to the estimates of lambda; what the iterate's forces differ from them enters linearly.
    const double estimate = std::max(now.multiplier, 0.);
    FrictionInput what = input(i, before, now, estimate);
    // A force that is an unknown has its own column, which those of the other points are not.
    what.coupled = shares() && what.normal_force > 0. && normal.derivative < 0.;
    const Curve &profile = projector_.counterpart().profile();
    what.slip_increment = offset_slip(profile, start(before, now), closest.arc_length, offset) - projector_.moving().own_way(i);
    FrictionResponse result = law_->update(what);
    result.force += result.force_rate * (normal.force - estimate);
    if (what.coupled)
      result.force += result.pressure_rate * mean_pressure(i).excess;
    return result;
  }


  SlipTransfer InterfaceFriction::transfer(const Projection &closest, const double offset) const
  {
    return slip_transfer(projector_.counterpart().profile(), offset, closest);
  }


  double InterfaceFriction::slip_to(const unsigned int i,
                                    const ContactPointState &before,
                                    const ContactPointState &now,
                                    const Place &end,
                                    const double offset) const
  {
    if (now.touching)
      return offset_slip(projector_.counterpart().profile(), start(before, now), end.arc_length, offset);
    // What has let go may be anywhere, also beyond the end of the tool: along the tangent where it was held last.
    const Projection last = projector_.look(i, before.position);
    return transfer(last, offset).share * ((end.position - before.position) * last.tangent);
  }
} // namespace deltaform
