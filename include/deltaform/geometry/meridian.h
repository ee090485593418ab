#pragma once

#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /// A straight or circular piece of the meridian of a blank.
  struct MeridianPiece
  {
    Point2 start;
    double angle = 0; ///< of the tangent at the start
    double curvature = 0; ///< d angle / d arc length; 0: straight
    double length = 0;
    double arc_start = 0; ///< arc length of the meridian at the start of the piece

    /// Angle of the tangent at @p s in [0, length].
    double angle_at(const double s) const
    {
      return angle + curvature * s;
    }

    Point2 point_at(double s) const;
  };

  /**
   * Pieces between corner points, with fillets.
   * @param radii one per point; the first and the last are ignored; 0 is a kink
   * @throws std::invalid_argument naming the corner if a fillet does not fit or two points coincide
   */
  std::vector<MeridianPiece> build_meridian(const std::vector<Point2> &points, const std::vector<double> &radii);
} // namespace deltaform
