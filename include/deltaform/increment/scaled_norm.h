#pragma once

#include <deltaform/assembly/types.h>

#include <cmath>
#include <vector>

namespace deltaform
{
  /// Norm of a change of the unknowns, each in its scale.
  inline double scaled_norm(const Vector &change, const std::vector<double> &scale)
  {
    double square = 0.;
    for (unsigned int i = 0; i < change.size(); ++i)
      square += (scale[i] * change[i]) * (scale[i] * change[i]);
    return std::sqrt(square);
  }
} // namespace deltaform
