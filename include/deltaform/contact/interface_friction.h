#pragma once

#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/friction_law.h>

#include <memory>
#include <utility>

namespace deltaform
{
  /// The law of friction of an interface, the slip of its points, and what it has to know of the blank.
  class InterfaceFriction
  {
  public:
    InterfaceFriction(std::unique_ptr<FrictionLaw> law, const ContactProjector &projector)
      : law_(std::move(law)), projector_(projector)
    {
    }

    const FrictionLaw &law() const
    {
      return *law_;
    }

    /// Largest |t| of point @p i at the normal force @p normal_force.
    double limit(unsigned int i,
                 const ContactPointState &before,
                 const ContactPointState &now,
                 const double normal_force) const
    {
      return law_->limit(input(i, before, now, normal_force)).value;
    }

    /// First touch of point @p i within an increment: its slip starts where it was when the increment began.
    void start_slip(unsigned int i, const ContactPointState &before, ContactPointState &now) const;

    /// Force of point @p i, whose face is @p offset away from its place, with its closest point @p closest, at
    /// the normal force @p normal_force.
    FrictionResponse respond(unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             const Projection &closest,
                             double offset,
                             double normal_force) const;

    /// What the point receives of that force.
    SlipTransfer transfer(const Projection &closest, double offset) const;

    /// Slip in this increment of a point that touches or did at its start, over the whole increment: a length along the
    /// tool.
    double slip_of_increment(unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             double offset) const;

  private:
    FrictionInput input(unsigned int i,
                        const ContactPointState &before,
                        const ContactPointState &now,
                        double normal_force) const;

    /// Arc length of the closest point where the slip of this increment starts.
    static double start(const ContactPointState &before, const ContactPointState &now)
    {
      return before.touching ? before.arc_length : now.slip_start;
    }

    std::unique_ptr<FrictionLaw> law_;
    const ContactProjector &projector_;
  };
} // namespace deltaform
