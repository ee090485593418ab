#pragma once

#include <deltaform/kinematics/mandel.h>

#include <array>

namespace deltaform
{
  /// A symmetric tensor of which the third axis is principal: components 11, 22, 33, 12 as they are.
  struct AxialTensor
  {
    double xx = 1, yy = 1, zz = 1, xy = 0;
  };

  /**
   * Logarithmic strain e = ln(b)/2 of a left Cauchy-Green tensor b, in Mandel order (11, 22, 33, sqrt(2) 12), and its
   * rate in a motion with the spatial velocity gradient l: db = l b + b l^T, components of l in the order
   * (11, 12, 21, 22, 33). It is the trial elastic strain of multiplicative plasticity.
   * A.L. Eterovic, K.J. Bathe, Int. J. Numer. Methods Eng. 30 (1990) 1099; J.C. Simo, Comput. Methods Appl. Mech. Eng.
   * 99 (1992) 61. Closed form in the plane and its limit at equal eigenvalues: doc/theory/solid.md.
   */
  struct LogarithmicStrain
  {
    using Rate = std::array<std::array<double, 5>, 4>;

    /// Strain only. @p b must be positive definite.
    static Mandel strain(const AxialTensor &b);

    /// d strain / d l, 4 x 5.
    static Rate rate(const AxialTensor &b);

    /// b = exp(2 e).
    static AxialTensor inverse(const Mandel &strain);
  };
} // namespace deltaform
