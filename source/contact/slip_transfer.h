#pragma once

#include <deltaform/contact/contact_force.h>
#include <deltaform/geometry/curvature.h>

namespace deltaform
{
  /**
   * c/(1 + k distance) with the mean curvature k of the tool over the thickness, and what sharp corners leave of the
   * friction, c. With the curvature at the closest point, and without c, the force would jump where a line meets an arc
   * or a corner, and a node that comes to rest there would have no equilibrium.
   */
  inline SlipTransfer slip_transfer(const Curve &profile, const double offset, const Projection &projection)
  {
    if (offset == 0. || projection.slip_rate == 0.)
      return {projection.slip_rate, -projection.curvature * projection.slip_rate, 0., projection.slip_rate};
    const CornerShare c = corner_share(profile, projection.arc_length, offset);
    const double k = mean_curvature(profile, projection.arc_length, offset);
    const double s = 1. / (1. + k * projection.distance);
    const double k_point = projection.curvature / (1. - projection.curvature * projection.distance);
    const double k_rate = curvature_change(profile, projection.arc_length, offset);
    return {c.value * s,
            -c.value * s * s * k,
            (c.slope * s - c.value * s * s * projection.distance * k_rate) * projection.slip_rate,
            projection.slip_rate * c.value * (1. + k_point * offset) / (1. + k * offset)};
  }
} // namespace deltaform
