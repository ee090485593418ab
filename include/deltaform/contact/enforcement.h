#pragma once

#include <deltaform/contact/pair_state.h>

namespace deltaform
{
  /// Normal force of a pair and what it depends on.
  struct NormalResponse
  {
    bool touching = false;
    double force = 0; ///< lambda; negative only between iterations
    double derivative = 0; ///< d lambda / d gap <= 0 (0 if the force is an unknown of its own)
    bool tied = false; ///< multiplier: gap + compliance lambda = 0 is demanded, else lambda = 0
    double compliance = 0; ///< of an exact constraint: sheet that is squeezed, continuation of a first touch
  };

  /**
   * How the constraint gap >= 0, lambda >= 0, gap lambda = 0 is imposed on one pair.
   *
   * Whether a pair is in contact is decided by the sign of multiplier - c gap, c > 0, not by the gap alone (semi-smooth
   * Newton, Hintermueller, Ito, Kunisch 2003): a pair whose reaction is compressive does not lose contact because a
   * step along the tangent of a curved tool has opened the gap by more than delta. c only weighs the two; at the
   * solution both agree.
   */
  class Enforcement
  {
  public:
    virtual ~Enforcement() = default;

    /// c of a pair: its share of the nodal stiffness.
    static double weight(const PairState &state)
    {
      return 1e-2 * state.stiffness;
    }

    /**
     * @param state      with epsilon and stiffness set
     * @param gap        current gap
     * @param multiplier current estimate of lambda: of the last linear solve, or the pair's own unknown
     */
    /// How far the contact point is from carrying no force: gap - shift / eps.
    static double effective_gap(const PairState &state, const double gap)
    {
      return state.shift > 0 ? gap - state.shift / state.epsilon : gap;
    }

    virtual NormalResponse respond(const PairState &state, double gap, double multiplier) const = 0;

    /// Does every pair have an unknown of its own, its force?
    virtual bool has_multiplier() const = 0;

    /// Does it use the penalty rule?
    virtual bool uses_penalty() const = 0;

    /// Force at zero gap that a pair begins an increment with; @p state has the new epsilon and the force of the last
    /// increment.
    virtual double start_shift(const PairState & /*state*/) const
    {
      return 0.;
    }

    /// Largest |gap| of a loaded pair, in units of delta, at which no further augmentation takes place; 0: the
    /// enforcement does not augment.
    virtual double augmentation_tolerance() const
    {
      return 0.;
    }
  };
} // namespace deltaform
