#include "slip_transfer.h"

#include <deltaform/contact/interface_friction.h>
#include <deltaform/geometry/curvature.h>

#include <algorithm>

namespace deltaform
{
  void InterfaceFriction::resize(const unsigned int n_points)
  {
    if (projector_.group() > 1 && law_->depends_on_pressure())
      mean_pressure_.assign(n_points / projector_.group(), 0.);
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
    double force = 0., area = 0.;
    for (unsigned int i = e * group; i < (e + 1) * group; i += stride)
      if (points[i].multiplier > 0.)
      {
        force += points[i].multiplier;
        area += points[i].area;
      }
    mean_pressure_[e] = area > 0. ? force / area : 0.;
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
      if (const double of_mean = mean_pressure_[i / projector_.group()] * now.area; of_mean > 0.)
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
                                              const double normal_force) const
  {
    // The limit belongs to the estimate of lambda; what the iterate's force differs from it enters linearly.
    const double estimate = std::max(now.multiplier, 0.);
    FrictionInput what = input(i, before, now, estimate);
    const Curve &profile = projector_.counterpart().profile();
    what.slip_increment = offset_slip(profile, start(before, now), closest.arc_length, offset);
    FrictionResponse result = law_->update(what);
    result.force += result.force_rate * (normal_force - estimate);
    return result;
  }


  SlipTransfer InterfaceFriction::transfer(const Projection &closest, const double offset) const
  {
    return slip_transfer(projector_.counterpart().profile(), offset, closest);
  }


  double InterfaceFriction::slip_of_increment(const unsigned int i,
                                              const ContactPointState &before,
                                              const ContactPointState &now,
                                              const double offset) const
  {
    if (now.touching)
      return offset_slip(projector_.counterpart().profile(), start(before, now), now.arc_length, offset);
    // What has let go may be anywhere, also beyond the end of the tool: along the tangent where it was held last.
    const Projection last = projector_.look(i, before.position);
    return transfer(last, offset).share * ((now.position - before.position) * last.tangent);
  }
} // namespace deltaform
