#pragma once

#include <deltaform/assembly/contact_point.h>
#include <deltaform/assembly/types.h>

#include <array>

namespace deltaform
{
  /// State of one contact point, accepted or on trial: a node of the blank, or a place inside an edge, over one tool.
  struct ContactPointState
  {
    bool touching = false; ///< lambda may be positive
    bool sticking = false;
    std::array<unsigned char, 6> filler{}; ///< points are saved as bytes: each one is set
    double gap = 0; ///< signed: distance of the contact point minus the offset
    double force = 0; ///< lambda; not negative once converged
    double previous_force = 0; ///< lambda one increment earlier
    double multiplier = 0; ///< estimate of lambda by the last linear solve: decides about the status
    double penalty_factor = 0; ///< eps (force/length); 0: not set yet
    double shift = 0; ///< force at zero gap: lambda = shift - eps gap (augmented forms)
    double last_penetration = 0; ///< when the rule was asked the last time
    double delta = 0; ///< allowed penetration
    double stiffness = 0; ///< K_nn of the blank when the penalty factor was set
    double compliance = 0; ///< through the thickness, of a touching point (ContactPoint::compliance)
    double arc_length = 0; ///< of the closest point
    double tangential_force = 0; ///< along growing arc length of the tool, on the tool
    double tangential_factor = 0; ///< eps_t (force/length)
    double slip_start = 0; ///< arc length where the slip of a first touch starts
    double slope = 0; ///< of the face against the tool (ContactProjector::slope()), of a touching point once accepted
    double slip = 0; ///< path of sliding so far (irreversible)
    double area = 0, thickness = 0; ///< tributary area and thickness of the blank there
    double noise = 0; ///< round-off of the gap, which is a difference of large numbers
    Point2 position; ///< of the contact point relative to the tool
    std::array<double, ContactPoint::max_dofs> residual{}; ///< added to the rows of its unknowns

    double penetration() const
    {
      return gap < 0 ? -gap : 0.;
    }

    /// By how much a penetration may exceed delta before the promise is broken: 1e-6 delta or round-off.
    double tolerance() const
    {
      return 1e-6 * delta > noise ? 1e-6 * delta : noise;
    }

    /// Of a change of the distance between tool and mid-surface, the share that the penalty spring takes; the sheet, a
    /// spring in series with it, takes the rest.
    double spring_share(const double through_thickness) const
    {
      return 1. / (1. + penalty_factor * through_thickness);
    }

    /// Put down where @p point is when its tool has gone by @p way.
    void set_place(const ContactPoint &point, const Tensor1 &way)
    {
      position = point.x - way;
      area = point.area;
      thickness = point.thickness;
    }

    /// May it bear a force?
    bool is_held() const
    {
      return touching || multiplier > 0.;
    }

    /// Bear the force of @p other from here on.
    void take_over(ContactPointState &other)
    {
      multiplier = other.multiplier;
      if (!(penalty_factor > 0.))
      {
        penalty_factor = other.penalty_factor;
        stiffness = other.stiffness;
        last_penetration = other.last_penetration;
      }
      touching = true;
      other.touching = false;
      other.multiplier = other.force = 0.;
    }

    /// The tool has left: the point stays where it is, without contact.
    void release()
    {
      ContactPointState free;
      free.area = area;
      free.thickness = thickness;
      free.position = position;
      *this = free;
    }
  };
} // namespace deltaform
