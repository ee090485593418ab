#pragma once

#include <algorithm>
#include <cmath>

namespace deltaform
{
  /// By how much an element may bend. Elements bend by a share of their angle squared too much, which matters most
  /// where the sheet hardly yields (doc/theory/shell.md).
  class BendLimit
  {
  public:
    /// @param largest angle (rad) @param elastic_curvature of the sheet where its faces begin to yield (1/length)
    BendLimit(const double largest, const double elastic_curvature)
      : largest_(largest), elastic_curvature_(elastic_curvature)
    {
    }

    /// At any curvature (rad).
    double largest() const
    {
      return largest_;
    }

    /// At a curvature of the sheet, regardless of sign, to the largest.
    double share(const double curvature) const
    {
      constexpr double least = .1;
      return curvature > elastic_curvature_ ? std::sqrt(std::max(least, 1. - elastic_curvature_ / curvature)) : 1.;
    }

    /// At a curvature, regardless of sign (rad).
    double at(const double curvature) const
    {
      return largest_ * share(curvature);
    }

  private:
    double largest_, elastic_curvature_;
  };
} // namespace deltaform
