#pragma once

#include "shell_points.h"

#include <deltaform/kinematics/mandel.h>
#include <deltaform/kinematics/shell_strain.h>

#include <array>
#include <cmath>

namespace deltaform
{
  /// How a place inside a shell moves, at a quadrature point on its meridian: any distance from the middle.
  class LayerMotion
  {
  public:
    /// @param ratio of the thickness to the initial one
    LayerMotion(const ShellPoint &point, const ShellStrain &strain, const double ratio, const bool axisymmetric)
      : point_(point), strain_(strain), ratio_(ratio), sine_(axisymmetric ? std::sin(point.angle) : 0.),
        axisymmetric_(axisymmetric)
    {
    }

    /// Now, from the middle (length). @param position: the initial one
    double distance(const double position) const
    {
      return ratio_ * position;
    }

    /// Stretches along and around, over their values at the mid-surface of the undeformed shell.
    std::array<double, 2> now(const double position) const
    {
      const double zeta = distance(position);
      return {{strain_.lambda - zeta * strain_.theta_prime, axisymmetric_ ? strain_.r + zeta * strain_.d_r() : 1.}};
    }

    /// The same of the undeformed shell.
    std::array<double, 2> before(const double position) const
    {
      return {{point_.lambda - position * point_.angle_prime, axisymmetric_ ? point_.radius - position * sine_ : 1.}};
    }

    /// Logarithmic; the third strain is left at zero.
    Mandel strain(const double position) const
    {
      const auto a = now(position), a_zero = before(position);
      return {{std::log(a[0] / a_zero[0]), axisymmetric_ ? std::log(a[1] / a_zero[1]) : 0., 0., 0.}};
    }

    /// Derivatives of both strains by the position (1/length).
    std::array<double, 2> slope(const double position) const
    {
      const auto a = now(position), a_zero = before(position);
      return {{-ratio_ * strain_.theta_prime / a[0] + point_.angle_prime / a_zero[0],
               axisymmetric_ ? ratio_ * strain_.d_r() / a[1] + sine_ / a_zero[1] : 0.}};
    }

  private:
    const ShellPoint &point_;
    const ShellStrain &strain_;
    double ratio_, sine_;
    bool axisymmetric_;
  };
} // namespace deltaform
