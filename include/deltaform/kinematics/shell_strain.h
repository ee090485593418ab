#pragma once

#include <deltaform/assembly/types.h>

#include <array>
#include <cmath>

namespace deltaform
{
  /**
   * Generalized strains of a shell of revolution (or of a strip) at one point of its meridian, with finite rotations
   * and stretches. Derivation and symbols: doc/theory/shell.md, after Reissner (1972) and Simo, Vu-Quoc (1986).
   *
   *     Lambda = x' . t      stretch along the rotated tangent t = (cos theta, sin theta)
   *     Gamma  = x' . d      shear against the director d = (-sin theta, cos theta)
   *     theta'               curvature
   *     r, d_r               radius and radial component of the director (hoop strain)
   */
  struct ShellStrain
  {
    enum : unsigned int
    {
      stretch,
      curvature,
      radius,
      director_r,
      shear,
      size
    };

    double cosine, sine; ///< of theta
    Tensor1 x_prime;
    double lambda, gamma, theta_prime, r;

    ShellStrain(const Tensor1 &derivative_of_x,
                const double theta,
                const double derivative_of_theta,
                const double radius_now)
      : cosine(std::cos(theta)), sine(std::sin(theta)), x_prime(derivative_of_x),
        lambda(x_prime[0] * cosine + x_prime[1] * sine), gamma(-x_prime[0] * sine + x_prime[1] * cosine),
        theta_prime(derivative_of_theta), r(radius_now)
    {
    }

    double d_r() const
    {
      return -sine;
    }

    /// Derivatives of the generalized strains with respect to (u_r, u_z, rotation) of a node with shape function N,
    /// dN/dS.
    std::array<std::array<double, 3>, size> derivative(const double shape, const double gradient) const
    {
      std::array<std::array<double, 3>, size> b{};
      b[stretch] = {{gradient * cosine, gradient * sine, gamma * shape}};
      b[curvature] = {{0., 0., gradient}};
      b[radius] = {{shape, 0., 0.}};
      b[director_r] = {{0., 0., -cosine * shape}};
      b[shear] = {{-gradient * sine, gradient * cosine, -lambda * shape}};
      return b;
    }

    /**
     * Second derivatives contracted with the generalized stresses @p n: the part of the tangent between a displacement
     * of the node with gradient dN/dS and a rotation with shape function M is dN/dS M mixed, between two rotations N M
     * rotation.
     */
    struct Geometric
    {
      Tensor1 mixed;
      double rotation;
    };

    Geometric geometric(const std::array<double, size> &n) const
    {
      Geometric g;
      g.mixed[0] = -n[stretch] * sine - n[shear] * cosine;
      g.mixed[1] = n[stretch] * cosine - n[shear] * sine;
      g.rotation = -n[stretch] * lambda - n[shear] * gamma + n[director_r] * sine;
      return g;
    }
  };
} // namespace deltaform
