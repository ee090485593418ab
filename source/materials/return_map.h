#pragma once

#include "elasticity.h"

#include <deltaform/materials/hardening.h>

#include <cmath>

namespace deltaform
{
  /**
   * J2 plasticity: what the return maps need of it. History of a point: the plastic strain (3x3, four Mandel
   * components) and the equivalent plastic strain.
   */
  struct J2
  {
    static constexpr unsigned int equivalent = 4; ///< place of the equivalent plastic strain, behind the plastic strain
    static constexpr unsigned int n_history = 5;

    const Elasticity &elastic;
    const Hardening &hardening;
    double initial_flow_stress;
  };

  /// How a return map ended.
  enum class PointOutcome : unsigned char
  {
    good,
    not_finite,
    not_converged
  };

  /// One point, all strains given; @p tangent may be null.
  PointOutcome radial_return(const J2 &j2,
                             const Mandel &strain,
                             const double *committed,
                             double *trial,
                             Mandel &stress,
                             double *tangent);

  /// One point, in-plane strains and third stress given, strain[2] is output; @p tangent may be null.
  PointOutcome plane_stress_return(const J2 &j2,
                                   Mandel &strain,
                                   double third_stress,
                                   const double *committed,
                                   double *trial,
                                   Mandel &stress,
                                   double *tangent);

  /// Elastic step: the history does not change.
  inline void keep_history(const double *committed, double *trial)
  {
    for (unsigned int i = 0; i < J2::n_history; ++i)
      trial[i] = committed[i];
  }

  /**
   * Equivalent plastic strain to be expected of this increment: that of the last iteration, or, just after a commit,
   * when the trial values are those of the increment before, the last increment's again.
   */
  inline double expected_increment(const double *committed, const double *trial)
  {
    return std::abs(trial[J2::equivalent] - committed[J2::equivalent]);
  }
} // namespace deltaform
