#pragma once

#include <deltaform/contact/contact_point_state.h>

#include <vector>

namespace deltaform
{
  /// Pressure of an edge that holds several contact points, over the area of those that carry force.
  struct MeanPressure
  {
    double value = 0; ///< of the estimates of lambda (force/area)
    double area = 0; ///< of the points with a positive one
    double excess = 0; ///< by how much that of the iterate's forces is above it

    MeanPressure() = default;

    /// Of the points from @p first to @p end in steps of @p stride.
    MeanPressure(const std::vector<ContactPointState> &points,
                 const unsigned int first,
                 const unsigned int end,
                 const unsigned int stride)
    {
      double estimate = 0., force = 0.;
      for (unsigned int i = first; i < end; i += stride)
        if (points[i].multiplier > 0.)
        {
          estimate += points[i].multiplier;
          force += points[i].touching ? points[i].force : 0.;
          area += points[i].area;
        }
      if (!(area > 0.))
        return;
      value = estimate / area;
      excess = (force - estimate) / area;
    }
  };
} // namespace deltaform
