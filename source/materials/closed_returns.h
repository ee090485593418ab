#pragma once

#include <deltaform/materials/return_map.h>

namespace deltaform
{
  /// Mises, isotropic hardening, all strains given.
  PointOutcome radial_return(const FlowLaw &law,
                             const Mandel &strain,
                             const double *committed,
                             double *trial,
                             Mandel &stress,
                             double *tangent);

  /// Mises, isotropic hardening, in-plane strains and third stress given.
  PointOutcome plane_stress_return(const FlowLaw &law,
                                   Mandel &strain,
                                   double third_stress,
                                   const double *committed,
                                   double *trial,
                                   Mandel &stress,
                                   double *tangent);

  /// The same for Hill 1948 with normal anisotropy @p r > -1/2, direction 3 normal to the sheet.
  PointOutcome plane_stress_return(double r,
                                   const FlowLaw &law,
                                   Mandel &strain,
                                   double third_stress,
                                   const double *committed,
                                   double *trial,
                                   Mandel &stress,
                                   double *tangent);
} // namespace deltaform
