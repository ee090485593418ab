#pragma once

#include <deltaform/assembly/energy.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/io/archive.h>

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

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive_plain(archive, points);
      archive &time &step &energy.stored &energy.friction &energy.friction_variance &energy.epsilon &energy.thickness;
      archive &energy.climbing;
    }
  };
} // namespace deltaform
