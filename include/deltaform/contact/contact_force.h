#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/contact/friction_law.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/geometry/curve.h>

namespace deltaform
{
  /// How friction at the closest point acts on the contact point: the share s of the tangential force, its derivatives
  /// along normal and tangent, and d(slip)/d(displacement along the tangent), which is s but for the penetration.
  struct SlipTransfer
  {
    double share = 0., along_normal = 0., along_tangent = 0., slip_rate = 0.;
  };

  /**
   * Force of a tool on a contact point, F = lambda N - t s tau with N the normal, tau the tangent of the tool and s =
   * d(closest point)/d(point), averaged. Derivation with its derivatives: doc/theory/contact.md.
   */
  class ContactForce
  {
  public:
    /// @param slip zero without friction
    ContactForce(const Projection &projection,
                 const SlipTransfer &slip,
                 const NormalResponse &normal,
                 const FrictionResponse &friction);

    /// On the blank (force).
    const Tensor1 &value() const
    {
      return value_;
    }

    /// N.
    const Tensor1 &normal() const
    {
      return projection_.normal;
    }

    /// dF/dlambda of a force that is an unknown of its own.
    Tensor1 by_multiplier() const;

    /// dF/d mean pressure of the edge (area).
    Tensor1 by_mean_pressure() const
    {
      return -friction_.pressure_rate * slip_.share * projection_.tangent;
    }

    /// d lambda/dx (force/length).
    Tensor1 normal_force_by_place() const
    {
      return normal_.derivative * projection_.normal;
    }

    /// dF/dx (force/length) at a constant mean pressure. @param pressing the normal force that turns with the tool's
    /// curvature: its estimate
    Tensor2 gradient(double pressing) const;

  private:
    Projection projection_;
    SlipTransfer slip_;
    NormalResponse normal_;
    FrictionResponse friction_;
    Tensor1 value_;
  };
} // namespace deltaform
