#include "turn.h"

#include <deltaform/geometry/segment.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    Tensor1 normal_of(const Tensor1 &tangent)
    {
      Tensor1 normal;
      normal[0] = -tangent[1];
      normal[1] = tangent[0];
      return normal;
    }
  } // namespace


  Segment line_segment(const Point2 &start, const Point2 &end, const Tensor1 &tangent, const double arc_start)
  {
    Segment line;
    line.kind = Segment::Kind::line;
    line.start = start;
    line.end = end;
    line.tangent = tangent;
    line.length = (end - start) * tangent;
    line.arc_start = arc_start;
    line.first = -length_tolerance * line.length;
    line.last = line.length * (1. + length_tolerance);
    line.lower = Point2(std::min(start[0], end[0]), std::min(start[1], end[1]));
    line.upper = Point2(std::max(start[0], end[0]), std::max(start[1], end[1]));
    return line;
  }


  Segment arc_segment(const Point2 &start,
                      const Point2 &end,
                      const Tensor1 &tangent_before,
                      const Tensor1 &tangent_after,
                      const double radius,
                      const double arc_start)
  {
    const double turn = std::atan2(cross(tangent_before, tangent_after), tangent_before * tangent_after);
    Segment arc;
    if (std::abs(turn) <= smallest_turn)
      return arc;
    arc.kind = Segment::Kind::arc;
    arc.convex = turn < 0;
    const double side = arc.convex ? 1. : -1.;
    arc.from = side * normal_of(tangent_before);
    arc.to = side * normal_of(tangent_after);
    arc.start = start;
    arc.end = end;
    arc.radius = radius;
    arc.center = start - radius * arc.from;
    arc.angle_start = std::atan2(arc.from[1], arc.from[0]);
    arc.sweep = turn;
    arc.length = radius * std::abs(turn);
    arc.arc_start = arc_start;

    // The box of the ends, and of those of the four extreme points of the circle that the arc passes.
    arc.lower = Point2(std::min(start[0], end[0]), std::min(start[1], end[1]));
    arc.upper = Point2(std::max(start[0], end[0]), std::max(start[1], end[1]));
    for (unsigned int d = 0; d < 2; ++d)
      for (const double sign : {-1., 1.})
      {
        Tensor1 extreme;
        extreme[d] = sign;
        if (-side * cross(arc.from, extreme) > 0 && -side * cross(extreme, arc.to) > 0)
          (sign < 0 ? arc.lower : arc.upper)[d] = arc.center[d] + sign * radius;
      }
    return arc;
  }
} // namespace deltaform
