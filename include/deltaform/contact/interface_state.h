#pragma once

#include <deltaform/assembly/energy.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/io/archive.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace deltaform
{
  /// What an interface knows at the end of an increment, accepted or on trial.
  struct InterfaceState
  {
    std::vector<ContactPointState> points;
    double time = 0; ///< end of the increment
    double step = 0; ///< its length; 0: none was accepted in this stage
    ContactEnergy energy; ///< zero where energies are off

    unsigned int n_touching() const
    {
      unsigned int count = 0;
      for (const auto &point : points)
        count += point.touching;
      return count;
    }

    /// How far a tool can go before it touches; 0 if it touches.
    double free_travel() const
    {
      double closest = std::numeric_limits<double>::infinity();
      for (const auto &point : points)
      {
        if (point.touching)
          return 0.;
        // A node on the axis has no area and no contact. Half of delta beyond the gap: only a penetration makes
        // contact.
        if (point.area > 0)
          closest = std::min(closest, std::max(point.gap, 0.) + .5 * point.delta);
      }
      return closest;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive_plain(archive, points);
      archive &time &step &energy.stored &energy.friction &energy.friction_variance &energy.epsilon &energy.thickness;
    }
  };
} // namespace deltaform
