#pragma once

#include <deltaform/contact/pair_state.h>

namespace deltaform
{
  /// Normal force of a pair and what it depends on.
  struct NormalResponse
  {
    bool   touching   = false;
    double force      = 0; ///< lambda >= 0
    double derivative = 0; ///< d lambda / d gap <= 0 (0 if the force is an unknown of its own)
    bool   tied       = false; ///< multiplier: gap + compliance lambda = 0 is demanded, else lambda = 0
    double compliance = 0; ///< not zero during the continuation of a first touch only
  };

  /// How the constraint gap >= 0, lambda >= 0, gap lambda = 0 is imposed on one pair.
  class Enforcement
  {
  public:
    virtual ~Enforcement() = default;

    /**
     * @param state      with epsilon and stiffness set
     * @param gap        current gap
     * @param multiplier current value of the pair's own unknown, if it has one
     */
    virtual NormalResponse
    respond(const PairState &state, double gap, double multiplier) const = 0;

    /// Does every pair have an unknown of its own, its force?
    virtual bool
    has_multiplier() const = 0;

    /// Does it use the penalty rule?
    virtual bool
    uses_penalty() const = 0;
  };
} // namespace deltaform
