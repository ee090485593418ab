#pragma once

#include <deltaform/base/types.h>

namespace deltaform
{
  /// State of one pair: one node and one tool.
  struct PairState
  {
    bool touching = false; ///< lambda may be positive
    bool sticking = false;
    double gap = 0; ///< signed: distance of the contact point minus the offset
    double force = 0; ///< lambda; not negative once converged
    double previous_force = 0; ///< lambda one increment earlier
    double multiplier = 0; ///< estimate of lambda by the last linear solve: decides about the status
    double epsilon = 0; ///< penalty factor; 0: not set yet
    double shift = 0; ///< force at zero gap: lambda = shift - eps gap (augmented forms)
    double last_penetration = 0; ///< p when the rule was asked the last time
    double delta = 0; ///< allowed penetration
    double stiffness = 0; ///< K_nn of the blank when epsilon was set
    double arc_length = 0; ///< of the foot point
    double tangential_force = 0; ///< along growing arc length of the tool, on the tool
    double epsilon_tangential = 0;
    double slip_start = 0; ///< arc length where the slip of a first touch starts
    double slip = 0; ///< path of sliding so far (irreversible)

    double penetration() const
    {
      return gap < 0 ? -gap : 0.;
    }
  };
} // namespace deltaform
