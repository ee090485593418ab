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
    bool tied = false; ///< active set only: the row is gap + compliance lambda = 0; else it is lambda = 0
    double compliance = 0; ///< [length/force] active set only: through-thickness compliance, or that of a first touch
  };

  /**
   * How gap >= 0, lambda >= 0, gap lambda = 0 is imposed on one contact point: by penalty, augmented Lagrangian or
   * active set.
   *
   * A point is in contact if multiplier - c gap > 0 with a weight c > 0 (semi-smooth Newton: Hintermueller, Ito,
   * Kunisch, SIAM J. Optim. 13 (2003) 865). The sign of the gap alone will not do: a step along the tangent of a curved
   * tool may open the gap by more than delta, and a point that carries a large force would lose contact. At the
   * solution both criteria agree. Derivation: doc/theory/contact.md.
   */
  class Enforcement
  {
  public:
    virtual ~Enforcement() = default;

    /// The weight c of a point [force/length]: a hundredth of its nodal stiffness.
    static double weight(const ContactPointState &state)
    {
      return 1e-2 * state.stiffness;
    }

    /// The gap at which the force is zero is shift / eps; this is the distance from it: gap - shift / eps.
    static double effective_gap(const ContactPointState &state, const double gap)
    {
      return state.shift > 0 ? gap - state.shift / state.penalty_factor : gap;
    }

    /**
     * @param state      with penalty factor and stiffness set
     * @param gap        current gap [length], negative: penetration
     * @param multiplier current estimate of lambda [force]: from the last linear solve, or the point's own unknown
     */
    virtual NormalResponse respond(const ContactPointState &state, double gap, double multiplier) const = 0;

    /// Is the force of every contact point an unknown (active set)?
    virtual bool has_multiplier() const = 0;

    /// Does it use the penalty rule?
    virtual bool uses_penalty() const = 0;

    /// Shift [force] at the start of an increment: the force at zero gap. @p state has the new penalty factor and the
    /// force of the last increment.
    virtual double start_shift(const ContactPointState & /*state*/) const
    {
      return 0.;
    }

    /// Augmentation ends where no loaded point has a |gap| above this multiple of delta; 0: there is no augmentation.
    virtual double augmentation_tolerance() const
    {
      return 0.;
    }
  };
} // namespace deltaform
