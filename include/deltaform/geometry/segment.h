#pragma once

#include <deltaform/assembly/types.h>

namespace deltaform
{
  /// A straight line or a circular arc of a curve; a corner is an arc of radius zero. "Convex": as seen from the left.
  struct Segment
  {
    enum class Kind : unsigned char
    {
      line,
      arc
    };

    Kind kind = Kind::line;
    bool convex = true; ///< arc: center on the tool's side
    Point2 start, end; ///< ends (equal for a corner)
    Point2 lower, upper; ///< smallest box that holds the segment
    double length = 0; ///< arc length (of an endless line: as drawn)
    double arc_start = 0; ///< arc length of the curve at the start
    Tensor1 tangent; ///< line: direction
    double first = 0, last = 0; ///< line: closest points have distances from the start within these, along the tangent
    Point2 center; ///< arc
    double radius = 0; ///< arc: >= 0
    Tensor1 from, to; ///< arc: unit vectors from the center to start and end (of a corner: +- the normals)
    double angle_start = 0; ///< arc: polar angle of `from`
    double sweep = 0; ///< arc: signed angle from start to end, negative if convex, |sweep| < pi
  };

  /// A line of length (@p end - @p start) along @p tangent. @param arc_start arc length of the curve at its start
  Segment line_segment(const Point2 &start, const Point2 &end, const Tensor1 &tangent, double arc_start);

  /// An arc that turns from one tangent to the other. @return of length zero and sweep zero if they do not differ
  Segment arc_segment(const Point2 &start,
                      const Point2 &end,
                      const Tensor1 &tangent_before,
                      const Tensor1 &tangent_after,
                      double radius,
                      double arc_start);
} // namespace deltaform
