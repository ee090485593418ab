#pragma once

#include <deltaform/contact/contact_force.h>
#include <deltaform/geometry/curvature.h>

namespace deltaform
{
  /**
   * 1/(1 + k distance) with the mean curvature k of the tool over the thickness. With that at the closest point the
   * force would jump where a line meets an arc, and a node that comes to rest there would have no equilibrium.
   */
  inline SlipTransfer slip_transfer(const Curve &profile, const double offset, const Projection &projection)
  {
    if (offset == 0. || projection.slip_rate == 0.)
      return {projection.slip_rate, -projection.curvature * projection.slip_rate, 0., projection.slip_rate};
    const double k = mean_curvature(profile, projection.arc_length, offset);
    const double s = 1. / (1. + k * projection.distance);
    const double k_point = projection.curvature / (1. - projection.curvature * projection.distance);
    return {s,
            -s * s * k,
            -s * s * projection.distance * projection.slip_rate *
              curvature_change(profile, projection.arc_length, offset),
            projection.slip_rate * (1. + k_point * offset) / (1. + k * offset)};
  }
} // namespace deltaform
