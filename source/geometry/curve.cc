// Closest point of a curve; the formulas are derived in doc/theory/tools.md.
#include "turn.h"

#include <deltaform/geometry/curve.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    // A point on the common normal of two segments belongs to both: their regions overlap by this angle (arcs) or by
    // this part of their length (lines, in build()).
    constexpr double angle_tolerance = 1e-12;

    double squared_distance_to_box(const Point2 &x, const Segment &segment)
    {
      const double a = std::max(0., std::max(segment.lower[0] - x[0], x[0] - segment.upper[0]));
      const double b = std::max(0., std::max(segment.lower[1] - x[1], x[1] - segment.upper[1]));
      return a * a + b * b;
    }

    // Distance without sign to the interior of a segment, infinite where the closest point is one of its ends.
    double unsigned_distance(const Point2 &x, const Segment &segment)
    {
      if (segment.kind == Segment::Kind::line)
      {
        const Tensor1 v = x - segment.start;
        const double t = v * segment.tangent;
        return t >= segment.first && t <= segment.last ? std::abs(cross(segment.tangent, v)) : infinity;
      }
      const Tensor1 v = x - segment.center;
      const double rho = v.norm(), sign = segment.convex ? -1. : 1., tolerance = -angle_tolerance * rho;
      const bool in_sector = sign * cross(segment.from, v) >= tolerance && sign * cross(v, segment.to) >= tolerance &&
                             v * segment.from + v * segment.to >= 0;
      return in_sector ? std::abs(rho - segment.radius) : infinity;
    }

    Projection on_line(const Point2 &x, const Segment &segment)
    {
      const Tensor1 v = x - segment.start;
      Projection p;
      p.tangent = segment.tangent;
      p.normal[0] = -segment.tangent[1];
      p.normal[1] = segment.tangent[0];
      p.distance = v * p.normal;
      p.curvature = 0.;
      p.slip_rate = 1.;
      p.arc_length = segment.arc_start + v * segment.tangent;
      return p;
    }

    Projection on_arc(const Point2 &x, const Segment &segment)
    {
      const Tensor1 v = x - segment.center;
      const double rho = v.norm(), side = segment.convex ? 1. : -1.;
      Projection p;
      p.distance = side * (rho - segment.radius);
      if (rho > 0)
      {
        // Divided, not multiplied by the inverse: on the axis the normal is exactly (0, 1).
        p.normal[0] = side * v[0] / rho;
        p.normal[1] = side * v[1] / rho;
        p.curvature = side / rho;
        p.slip_rate = segment.radius / rho;
        const double angle = std::atan2(-side * cross(segment.from, v), segment.from * v);
        p.arc_length = segment.arc_start + segment.radius * angle;
      }
      else // at the center every point of the arc is closest: take the middle, and do not let it turn
      {
        const Tensor1 middle = segment.from + segment.to;
        p.normal = (side / middle.norm()) * middle;
        p.curvature = p.slip_rate = 0.;
        p.arc_length = segment.arc_start + .5 * segment.length;
      }
      p.tangent[0] = p.normal[1];
      p.tangent[1] = -p.normal[0];
      return p;
    }

    Projection nowhere(const unsigned int hint)
    {
      Projection p;
      p.distance = infinity;
      p.curvature = p.slip_rate = p.arc_length = 0.;
      p.segment = hint;
      return p;
    }
  } // namespace


  Projection Curve::project(const Point2 &x, const unsigned int hint) const
  {
    const bool mirrored = x[0] < 0 && (start_ == End::axis || end_ == End::axis);
    if (!mirrored)
      return project_one_side(x, hint);

    Projection p = project_one_side(Point2(-x[0], x[1]), hint);
    p.normal[0] = -p.normal[0];
    p.tangent[1] = -p.tangent[1];
    p.arc_length = start_ == End::axis ? -p.arc_length : 2 * length() - p.arc_length;
    return p;
  }


  Projection Curve::project_one_side(const Point2 &x, const unsigned int hint) const
  {
    const unsigned int n_segments = static_cast<unsigned int>(segments_.size());
    unsigned int closest = hint;
    double distance = hint < n_segments ? unsigned_distance(x, segments_[hint]) : infinity;

    for (unsigned int i = 0; i < n_segments; ++i)
      if (i != hint && squared_distance_to_box(x, segments_[i]) < distance * distance)
      {
        const double candidate = unsigned_distance(x, segments_[i]);
        if (candidate < distance)
        {
          distance = candidate;
          closest = i;
        }
      }

    // The factor lets the closest point be the free end itself.
    for (const Point2 &end : free_ends_)
      if (end.distance_square(x) < distance * distance * (1 - angle_tolerance))
        return nowhere(hint);
    if (distance == infinity)
      return nowhere(hint);

    const Segment &segment = segments_[closest];
    Projection p = segment.kind == Segment::Kind::line ? on_line(x, segment) : on_arc(x, segment);
    p.segment = closest;
    return p;
  }


  double Curve::length() const
  {
    return segments_.empty() ? 0. : segments_.back().arc_start + segments_.back().length;
  }


  double Curve::slip(const double a, const double b) const
  {
    return closed_ ? std::remainder(b - a, length()) : b - a;
  }


  std::pair<Point2, Point2> Curve::bounding_box() const
  {
    Point2 lower(infinity, infinity), upper(-infinity, -infinity);
    for (const Segment &segment : segments_)
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], segment.lower[d]);
        upper[d] = std::max(upper[d], segment.upper[d]);
      }
    if (start_ == End::axis || end_ == End::axis)
      lower[0] = std::min(lower[0], -upper[0]);
    return {lower, upper};
  }


  std::vector<Point2> Curve::polyline(const double angle, const double reach, const bool both_sides) const
  {
    std::vector<Point2> points;
    if (segments_.empty())
      return points;

    const Segment &front = segments_.front(), &back = segments_.back();
    points.push_back(start_ == End::endless ? front.end - std::max(front.length, reach) * front.tangent : front.start);
    for (const Segment &segment : segments_)
    {
      const unsigned int n =
        segment.radius > 0 ? std::max(1u, static_cast<unsigned int>(std::ceil(std::abs(segment.sweep) / angle))) : 1u;
      for (unsigned int i = 1; i < n; ++i)
      {
        const double a = segment.angle_start + segment.sweep * i / n;
        points.push_back(segment.center + segment.radius * Point2(std::cos(a), std::sin(a)));
      }
      if (segment.length > 0)
        points.push_back(segment.end);
    }
    if (end_ == End::endless)
      points.back() = back.start + std::max(back.length, reach) * back.tangent;

    if (both_sides && (start_ == End::axis || end_ == End::axis))
    {
      std::vector<Point2> image(points.rbegin(), points.rend());
      for (Point2 &point : image)
        point[0] = -point[0];
      std::vector<Point2> &first = start_ == End::axis ? image : points, &second = start_ == End::axis ? points : image;
      first.insert(first.end(), second.begin() + 1, second.end());
      return first;
    }
    return points;
  }
} // namespace deltaform
