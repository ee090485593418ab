#pragma once

#include <cmath>

namespace deltaform
{
  /**
   * Young's modulus that falls with the equivalent plastic strain e, as it is measured when metal is
   * released and loaded again:
   *
   *     E(e) = E0 - (E0 - Ea) (1 - exp(-xi e)),   0 < Ea <= E0 stresses, xi >= 0; nu is constant.
   *
   * In increments d tau = C(e) : (d strain - d plastic strain): a change of e alone does not change the
   * stress.
   * F. Yoshida, T. Uemori, K. Fujiwara, Elastic-plastic behavior of steel sheets under in-plane cyclic
   * tension-compression at large strain, Int. J. Plasticity 18 (2002) 633.
   */
  struct FallingModulus
  {
    double saturated; ///< Ea
    double rate; ///< xi

    double operator()(const double initial, const double equivalent_plastic_strain) const
    {
      return initial + (initial - saturated) * std::expm1(-rate * equivalent_plastic_strain);
    }
  };
} // namespace deltaform
