#pragma once

#include <deltaform/materials/material.h>

#include <cmath>

namespace deltaform
{
  /// Equivalent stress of von Mises.
  inline double mises(const Mandel &t)
  {
    const double mean = (t[0] + t[1] + t[2]) / 3.;
    double square = t[3] * t[3];
    for (unsigned int k = 0; k < 3; ++k)
      square += (t[k] - mean) * (t[k] - mean);
    return std::sqrt(1.5 * square);
  }
} // namespace deltaform
