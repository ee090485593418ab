#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/contact/contact_point_state.h>

#include <optional>
#include <vector>

namespace deltaform
{
  class ContactForce;
  class PointRows;

  /// Answer of a normal law: whether a point touches, its force, and the derivative by the gap.
  struct NormalResponse
  {
    bool touching = false;
    double force = 0; ///< lambda; negative only between iterations
    double derivative = 0; ///< d lambda / d gap <= 0 (0 if the force is an unknown of its own)
    bool tied = false; ///< active set only: the row is gap + compliance lambda = 0; else it is lambda = 0
    double compliance = 0; ///< [length/force] active set only: through-thickness compliance, or that of a first touch
    double gap = 0; ///< that is left when the face has given way
  };

  /// What an interface knows of a point when it asks for its normal force.
  struct NormalSituation
  {
    double gap = 0; ///< between the tool and the face, which has not yet given way
    double compliance = 0; ///< [length/force] of the face: the through-thickness compliance
    double share = 1; ///< of the stiffness that counts: less than 1 while contact is stiffened step by step
    std::optional<bool> foreseen; ///< the set of touching points is given, and the point belongs to it or not
    bool held = false; ///< the point touched in the accepted state, and no step has been made since: it still does
  };

  /**
   * How gap >= 0, lambda >= 0, gap lambda = 0 is imposed on one contact point: by penalty, augmented Lagrangian or
   * active set. A law whose force is an unknown owns that unknown, its equation and its column.
   *
   * A point is in contact if multiplier - c gap > 0 with a weight c > 0 (semi-smooth Newton: Hintermueller, Ito,
   * Kunisch, SIAM J. Optim. 13 (2003) 865). The sign of the gap alone will not do: a step along the tangent of a curved
   * tool may open the gap by more than delta, and a point that carries a large force would lose contact. At the
   * solution both criteria agree. Derivation: doc/theory/contact.md.
   */
  class NormalLaw
  {
  public:
    virtual ~NormalLaw() = default;

    /// The weight c of a point [force/length]: a hundredth of its nodal stiffness.
    static double weight(const ContactPointState &state)
    {
      return 1e-2 * state.stiffness;
    }

    /**
     * @param state      with penalty factor and stiffness set
     * @param gap        current gap [length], negative: penetration
     * @param multiplier current estimate of lambda [force]: from the last linear solve, or the point's own unknown
     */
    virtual NormalResponse respond(const ContactPointState &state, double gap, double multiplier) const = 0;

    /// The same of a point in its interface: with the compliance in series, and a status that the iteration holds.
    virtual NormalResponse respond(const ContactPointState &state, const NormalSituation &situation) const = 0;

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

    /// @name Status
    ///@{
    /// Has the point no force as long as its face is clear of the tool?
    virtual bool is_free_when_clear(const ContactPointState &state) const = 0;

    /// Is its force evaluated at the present gap, so that it needs penalty factors?
    virtual bool is_concerned(const ContactPointState &state) const = 0;

    /// Share of its stiffness with which contact may begin where a stiff one is not solved: of springs that of every
    /// point, of exact constraints (whose stiffness is that of the blank) that of first touches.
    double soft_share() const
    {
      return uses_penalty() ? .03 : 1e-4; // doc/decisions/README.md, "Soft contact"
    }

    /// Estimate of lambda after a step that opens the gap by @p opening (length), with this share of the stiffness.
    virtual double estimate(const ContactPointState &state, double opening, double share) const = 0;

    /**
     * Will a point touch after a step that opens the distance between tool and face by @p opening (length), if that is
     * linear? @p compliance of the face [length/force]. A law that cannot say so returns the present status.
     */
    virtual bool foresee(const ContactPointState &state, const double /*opening*/, const double /*compliance*/) const
    {
      return state.touching;
    }

    /// Is an equilibrium with this @p state a solution? @p allowed_tension: force; @p final: contact is not soft any more
    virtual bool is_solution(const ContactPointState &state, double allowed_tension, bool final) const;
    ///@}

    /// @name A law whose force is an unknown: one per point
    ///@{
    virtual bool has_multiplier() const
    {
      return false;
    }

    /// The unknowns, from @p first on, of accepted points.
    virtual void
    start(const std::vector<ContactPointState> & /*points*/, const DofIndex /*first*/, Vector & /*q*/) const
    {
    }

    /// The estimate of lambda is the unknown @p own itself.
    virtual void read_unknown(const Vector & /*q*/, const DofIndex /*own*/, ContactPointState & /*state*/) const
    {
    }

    /// Does a point with this response add to residual or tangent?
    virtual bool acts(const NormalResponse &response) const
    {
      return response.touching;
    }

    /// The unknown @p own joins those that move the point.
    virtual void join(PointRows & /*rows*/, const DofIndex /*own*/) const
    {
    }

    /// Equation and column of the unknown. @p compliance of the face [length/force]
    virtual void add_equation(const NormalResponse & /*response*/,
                              const ContactPointState & /*state*/,
                              const double /*compliance*/,
                              const ContactForce & /*force*/,
                              PointRows & /*rows*/) const
    {
    }

    /// The equation of a point that is too far away to be evaluated.
    virtual void close(const Vector & /*q*/, const DofIndex /*own*/, AssemblyTarget & /*target*/) const
    {
    }
    ///@}
  };
} // namespace deltaform
