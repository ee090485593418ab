#pragma once

#include <deltaform/contact/contact_point_state.h>

namespace deltaform
{
  /// Normal force of a contact point and what it depends on.
  struct NormalResponse
  {
    bool touching = false;
    double force = 0; ///< lambda; negative only between iterations
    double derivative = 0; ///< d lambda / d gap <= 0 (0 if the force is an unknown of its own)
    bool tied = false; ///< multiplier: gap + compliance lambda = 0 is demanded, else lambda = 0
    double compliance = 0; ///< of an exact constraint: through the thickness, continuation of a first touch
  };

  /**
   * How the constraint gap >= 0, lambda >= 0, gap lambda = 0 is imposed on one contact point.
   *
   * Whether a point is in contact is decided by the sign of multiplier - c gap, c > 0, not by the gap alone
   * (semi-smooth Newton, Hintermueller, Ito, Kunisch 2003): a point whose reaction is compressive does not lose contact
   * because a step along the tangent of a curved tool has opened the gap by more than delta. c only weighs the two; at
   * the solution both agree.
   */
  class Enforcement
  {
  public:
    virtual ~Enforcement() = default;

    /// c of a point: its share of the nodal stiffness.
    static double weight(const ContactPointState &state)
    {
      return 1e-2 * state.stiffness;
    }

    /// How far the contact point is from carrying no force: gap - shift / eps.
    static double effective_gap(const ContactPointState &state, const double gap)
    {
      return state.shift > 0 ? gap - state.shift / state.penalty_factor : gap;
    }

    /**
     * @param state      with penalty factor and stiffness set
     * @param gap        current gap
     * @param multiplier current estimate of lambda: of the last linear solve, or the point's own unknown
     */
    virtual NormalResponse respond(const ContactPointState &state, double gap, double multiplier) const = 0;

    /// Does every contact point have an unknown of its own, its force?
    virtual bool has_multiplier() const = 0;

    /// Does it use the penalty rule?
    virtual bool uses_penalty() const = 0;

    /// Force at zero gap that a point begins an increment with; @p state has the new penalty factor and the force of
    /// the last increment.
    virtual double start_shift(const ContactPointState & /*state*/) const
    {
      return 0.;
    }

    /// Largest |gap| of a loaded point, in units of delta, at which no further augmentation takes place; 0: the
    /// enforcement does not augment.
    virtual double augmentation_tolerance() const
    {
      return 0.;
    }
  };
} // namespace deltaform
