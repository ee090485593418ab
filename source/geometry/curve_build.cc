// From corner points and fillet radii to lines and arcs.
#include <deltaform/geometry/curve.h>
#include <deltaform/geometry/fillets.h>
#include <deltaform/parameters/text.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace deltaform
{
  Curve::Curve(const std::vector<Point2> &points,
               const std::vector<double> &radii,
               const End start,
               const End end)
    : start_(start), end_(end)
  {
    const FilletedCorners corners(points, radii, false);
    for (const auto &[what, point] : {std::make_pair(start, points.front()), std::make_pair(end, points.back())})
      if (what == End::axis && point[0] != 0.)
        throw std::invalid_argument("An end of a profile that is said to be on the axis has r = " +
                                    text::rounded(point[0]) + ".");
    add_segments(points, radii, corners);
    end_with(start_, segments_.front(), points.front(), -1.);
    end_with(end_, segments_.back(), points.back(), 1.);
  }


  Curve Curve::closed(const std::vector<Point2> &points, const std::vector<double> &radii)
  {
    Curve result;
    result.closed_ = true;
    result.add_segments(points, radii, FilletedCorners(points, radii, true));
    return result;
  }


  void Curve::add_segments(const std::vector<Point2> &points,
                           const std::vector<double> &radii,
                           const FilletedCorners &corners)
  {
    const auto add_arc = [&](const Point2 &from, const Point2 &to, const Tensor1 &a, const Tensor1 &b, const double r) {
      const Segment arc = arc_segment(from, to, a, b, r, length());
      if (arc.sweep != 0.)
        segments_.push_back(arc);
    };
    const auto add_corner = [&](const unsigned int i) {
      const Tensor1 &a = corners.tangent_before(i), &b = corners.tangent(i);
      add_arc(points[i] - corners.setback(i) * a, points[i] + corners.setback(i) * b, a, b, radii[i]);
    };

    // A half corner where the curve leaves or meets the axis at an angle; the other half is its mirror image.
    const Tensor1 outward = Point2(1., 0.);
    if (start_ == End::axis)
      add_arc(points.front(), points.front(), outward, corners.tangent(0), 0.);
    if (closed_)
      add_corner(0);
    for (unsigned int e = 0; e < corners.n_edges(); ++e)
    {
      const unsigned int next = (e + 1) % corners.n_points();
      const Tensor1 &tangent = corners.tangent(e);
      if (corners.straight(e) > 0.)
        segments_.push_back(line_segment(points[e] + corners.setback(e) * tangent,
                                         points[next] - corners.setback(next) * tangent,
                                         tangent,
                                         length()));
      if (corners.is_corner(next) && next != 0)
        add_corner(next);
    }
    if (end_ == End::axis)
      add_arc(points.back(), points.back(), corners.tangent(corners.n_edges() - 1), -outward, 0.);
  }


  void Curve::end_with(const End what, Segment &segment, const Point2 &point, const double sign)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (what == End::free)
      free_ends_.push_back(point);
    if (what != End::endless)
      return;
    if (segment.kind != Segment::Kind::line)
      throw std::invalid_argument("A profile that goes on for ever must end with a line.");
    (sign < 0 ? segment.first : segment.last) = sign * infinity;
    for (unsigned int d = 0; d < 2; ++d)
      if (segment.tangent[d] != 0.)
        (sign * segment.tangent[d] < 0 ? segment.lower : segment.upper)[d] =
          std::copysign(infinity, sign * segment.tangent[d]);
  }
} // namespace deltaform
