#pragma once

#include <deltaform/materials/material.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  /**
   * Isotropic elasticity in the logarithmic strain (Hencky's law):
   *
   *     tau = K tr(e) 1 + 2 G dev(e),   K = E / (3 (1 - 2 nu)),   G = E / (2 (1 + nu)),
   *
   * tau the Kirchhoff stress, e the elastic logarithmic strain, E and K and G stresses. For metals, whose elastic
   * strains stay small, it differs from other hyperelastic laws by terms of second order.
   * L. Anand, On H. Hencky's approximate strain-energy function for moderate deformations, J. Appl. Mech. 46 (1979) 78.
   */
  struct Elasticity
  {
    double young, poisson;
    double shear, bulk;
    double plane_stress; ///< E / (1 - nu^2)
    double biaxial; ///< E / (1 - nu): in-plane stress of an equal in-plane strain at third stress 0
    double shift; ///< (1 - 2 nu) / E: strain of a unit pressure
    double compliance; ///< 1 / (2 G)
    double contraction; ///< nu / E
    std::array<double, 16> tangent; ///< d stress / d strain, 4 x 4, row-major
    std::array<double, 16> condensed_tangent; ///< the same at given third stress: row and column [2] are zero

    /// Young's modulus @p E > 0 (stress), Poisson's ratio @p nu in (-1, 1/2).
    Elasticity(const double E, const double nu)
      : young(E), poisson(nu), shear(E / (2. * (1. + nu))), bulk(E / (3. * (1. - 2. * nu))),
        plane_stress(E / ((1. - nu) * (1. + nu))), biaxial(E / (1. - nu)), shift((1. - 2. * nu) / E),
        compliance((1. + nu) / E), contraction(nu / E)
    {
      const double common = bulk - 2. / 3. * shear, direct = common + 2. * shear, mixed = nu * plane_stress;
      // clang-format off
      tangent           = {{direct, common, common, 0.,
                            common, direct, common, 0.,
                            common, common, direct, 0.,
                            0.,     0.,     0.,     2. * shear}};
      condensed_tangent = {{plane_stress, mixed,        0., 0.,
                            mixed,        plane_stress, 0., 0.,
                            0.,           0.,           0., 0.,
                            0.,           0.,           0., 2. * shear}};
      // clang-format on
    }

    /// Stress of the elastic strain @p e.
    Mandel stress(const Mandel &e) const
    {
      const double trace = e[0] + e[1] + e[2];
      const double common = (bulk - 2. / 3. * shear) * trace;
      return {{common + 2. * shear * e[0], common + 2. * shear * e[1], common + 2. * shear * e[2], 2. * shear * e[3]}};
    }

    /// The elastic strain of a state of stress.
    Mandel strain(const Mandel &tau) const
    {
      const double common = -contraction * (tau[0] + tau[1] + tau[2]);
      return {{compliance * tau[0] + common,
               compliance * tau[1] + common,
               compliance * tau[2] + common,
               compliance * tau[3]}};
    }

    /// The elastic strain along direction 3 of a state of stress.
    double third_strain(const Mandel &tau) const
    {
      return (tau[2] - poisson * (tau[0] + tau[1])) / young;
    }

    /// Per reference volume.
    double energy(const Mandel &tau) const
    {
      const double trace = tau[0] + tau[1] + tau[2];
      const double square = tau[0] * tau[0] + tau[1] * tau[1] + tau[2] * tau[2] + tau[3] * tau[3];
      return .5 * (compliance * square - contraction * trace * trace);
    }
  };
} // namespace deltaform
