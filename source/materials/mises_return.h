#pragma once

#include <deltaform/materials/return_map.h>

namespace deltaform
{
  /// Mises, isotropic hardening, all strains given.
  PointOutcome radial_return(const FlowLaw &law, const ReturnPoint &point);

  /// Mises, isotropic hardening, in-plane strains and third stress given.
  PointOutcome plane_stress_return(const FlowLaw &law, const ReturnPoint &point);
} // namespace deltaform
