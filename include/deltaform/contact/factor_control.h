#pragma once

#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/contact_settings.h>
#include <deltaform/contact/interface_friction.h>
#include <deltaform/contact/interface_state.h>

#include <array>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * The factors of the springs between blank and tool: the normal ones by the penalty rule, the tangential ones by the
   * allowed elastic slip. They are predicted when an increment begins and when a point touches for the first time,
   * and corrected where penetration <= delta is not kept: close to equilibrium by rules that promise it, by all rules
   * after a Newton solve. Where a solve does not converge the normal ones are softened for a while.
   */
  class FactorControl
  {
  public:
    using Points = std::vector<ContactPointState>;

    /// @param friction null: none
    FactorControl(const ContactSettings &settings,
                  const ContactProjector &projector,
                  const InterfaceFriction *friction);

    /// The increment that ends at @p time starts from @p committed, whose last step says how fast forces grow.
    void begin_increment(double time, const InterfaceState &committed);

    /// Store the blocks of the blank's stiffness that belong to the points; contact has not yet been added to @p
    /// stiffness.
    void read_stiffness(const Vector &q, const StiffnessView &stiffness, Points &trial);

    /// Add C (penetration - delta) of the touching points, for the rule's coupling. @p shift: way of the tool
    void add_mismatch(const Vector &q, const Tensor1 &shift, const Points &trial, Vector &direction) const;

    /// Give every touching point its factor and shift. @param coupling K C (penetration - delta), or null if no rule
    /// needs it
    void predict(const Vector &q,
                 const Tensor1 &shift,
                 const Vector *coupling,
                 const Points &committed,
                 Points &trial) const;

    /// First touch of point @p i within this increment.
    void touch(unsigned int i,
               const ContactPoint &point,
               const Projection &projection,
               const Points &committed,
               Points &trial) const;

    /// Between two iterations close to equilibrium: the normal factors of a rule that promises, and the tangential
    /// ones. They only grow. @param touching points @return how many have other factors than before
    unsigned int correct_early(const std::vector<unsigned int> &touching, Points &trial) const;

    /// After a converged solve. @return how many points have other factors than before
    unsigned int correct(Points &trial);

    /// Continuation: points begin with this share of their factors (active set: first touches with one of their own
    /// stiffness) and are stiffened to the full after each converged solve.
    void soften(const double share)
    {
      softening_ = share;
    }

    bool softened() const
    {
      return softening_ < 1;
    }

    /// Share of the normal factor of a point that counts now. @param before its accepted state
    double share(const ContactPointState &before) const
    {
      return before.touching && !settings_.normal_law->uses_penalty() ? 1. : softening_;
    }

    /// Is the lower bound larger than what delta asks for at point @p i?
    bool governed_by_floor(unsigned int i, const Points &points) const;

    /// The point that breaks the promise most, beyond round-off, and its penetration/delta; invalid_index: none does.
    static std::pair<unsigned int, double> broken_promise(const Points &points);

  private:
    /// Of one touching point. @param coupling [C^T K C (penetration - delta)]_i, or 0
    void predict(unsigned int i,
                 const ContactPoint &point,
                 const Projection &projection,
                 double coupling,
                 const Points &committed,
                 Points &trial) const;

    /// K_nn (or K_tt) = (J^T n)^T K (J^T n) with the block of the blank's tangent.
    double point_stiffness(unsigned int i, const ContactPoint &point, const Tensor1 &direction) const;

    PenaltyInput input(unsigned int i, const Points &points, double coupling) const;

    /// By how much the reaction is expected to grow in this increment: as in the last one, at most to twice itself. A
    /// factor for the force of the last increment alone is too soft for a growing one and costs a correction.
    double expected_growth(const ContactPointState &before) const;

    double tangential_factor(unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             double stiffness) const;

    /// Both factors of a point, the normal one if @p normal. @return has one changed?
    ///@{
    bool correct(unsigned int i, bool normal, Points &trial) const;
    bool correct_normal(unsigned int i, Points &trial) const;
    bool correct_tangential(ContactPointState &state) const; ///< of a sticking point that creeps too far
    ///@}

    const ContactSettings &settings_;
    const ContactProjector &projector_;
    const InterfaceFriction *friction_;
    /// Of the blank's tangent at the start of the increment, for the unknowns of a point, or of an edge's points.
    struct Block
    {
      std::array<DofIndex, ContactPoint::max_dofs> dofs;
      std::array<double, ContactPoint::max_dofs * ContactPoint::max_dofs> values; ///< as many rows as unknowns
    };

    std::vector<Block> blocks_; ///< of each point, or each edge
    double median_ = 0; ///< of the accepted factors
    double step_ = 0, last_step_ = 0; ///< lengths of this increment and the last one; 0: there is none
    double softening_ = 1; ///< share of the normal factors that counts
    double slip_limit_ = 0; ///< allowed elastic slip at the end of the increment
  };
} // namespace deltaform
