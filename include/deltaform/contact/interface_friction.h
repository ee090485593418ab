#pragma once

#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/friction_law.h>
#include <deltaform/contact/mean_pressure.h>

#include <memory>
#include <utility>
#include <vector>

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

    /// @name Mean pressure of edges that hold several points
    /// Which of them carry the force of the edge is nearly arbitrary, and a law that is not linear in lambda would see
    /// it: the points share the limit of their mean pressure (doc/theory/friction.md).
    ///@{
    /// There are so many contact points.
    void resize(unsigned int n_points);

    /// An increment begins with the accepted forces.
    void begin_increment(const std::vector<ContactPointState> &points);

    /// Is the mean pressure of interest?
    bool shares() const
    {
      return !mean_pressure_.empty();
    }

    /// The forces of edge @p e are others. @p stride: from each point that counts to the next one
    void look_at(unsigned int e, const std::vector<ContactPointState> &points, unsigned int stride);

    /// Of the edge of point @p i.
    const MeanPressure &mean_pressure(const unsigned int i) const
    {
      return mean_pressure_[i / projector_.group()];
    }
    ///@}

    /// Largest |t| of point @p i at the normal force @p normal_force.
    double limit(unsigned int i,
                 const ContactPointState &before,
                 const ContactPointState &now,
                 const double normal_force) const
    {
      const FrictionInput what = input(i, before, now, normal_force);
      return what.share * law_->limit(what).value;
    }

    /// First touch of point @p i within an increment: its slip starts where it was when the increment began.
    void start_slip(unsigned int i, const ContactPointState &before, ContactPointState &now) const;

    /// Force of point @p i, whose face is @p offset away from its place, with its closest point @p closest, at
    /// the normal force @p normal.
    FrictionResponse respond(unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             const Projection &closest,
                             double offset,
                             const NormalResponse &normal) const;

    /// What the point receives of that force.
    SlipTransfer transfer(const Projection &closest, double offset) const;

    /// Slip in this increment of a point that touches or did at its start, over the whole increment: a length along the
    /// tool.
    double slip_of_increment(const unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             const double offset) const
    {
      return slip_to(i, before, now, {now.position, now.arc_length}, offset) - projector_.moving().own_way(i);
    }

    /// A place relative to the tool, and the arc length of its closest point.
    struct Place
    {
      Point2 position;
      double arc_length;
    };

    /// As if the slip had ended at @p end.
    double slip_to(unsigned int i,
                   const ContactPointState &before,
                   const ContactPointState &now,
                   const Place &end,
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
    std::vector<MeanPressure> mean_pressure_; ///< edge by edge; empty: of no interest
  };
} // namespace deltaform
