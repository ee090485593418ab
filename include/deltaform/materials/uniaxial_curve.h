#pragma once

#include <deltaform/materials/material.h>

#include <vector>

namespace deltaform
{
  /// A law in uniaxial tension, from the start.
  struct UniaxialPoint
  {
    double plastic_strain; ///< equivalent
    double modulus; ///< d(stress)/d(strain), Kirchhoff stress over logarithmic strain (stress)
  };

  /// Pull the law, in plane stress with the lateral stress kept at zero, to a strain of 1, or as far as it gives a
  /// stress. The plastic strain grows from point to point.
  std::vector<UniaxialPoint> uniaxial_curve(const Material &law);

  /// The modulus at a @p plastic_strain, linear between the points and constant beyond them.
  double tangent_modulus(const std::vector<UniaxialPoint> &curve, double plastic_strain);
} // namespace deltaform
