#include <deltaform/tools/shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

// From corner points and fillet radii to lines and arcs.

namespace deltaform
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    // Corners that turn by less are straight; lines shorter than this part of their edge are none.
    constexpr double smallest_turn = 1e-9;
    constexpr double length_tolerance = 1e-12;

    double cross(const Tensor1 &a, const Tensor1 &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    // Component by component, because deal.II multiplies by the inverse, and (1, 0) must stay exactly that.
    Tensor1 direction_of(const Tensor1 &edge, const double length)
    {
      Tensor1 direction;
      direction[0] = edge[0] / length;
      direction[1] = edge[1] / length;
      return direction;
    }

    Tensor1 normal_of(const Tensor1 &tangent)
    {
      Tensor1 normal;
      normal[0] = -tangent[1];
      normal[1] = tangent[0];
      return normal;
    }

    std::string corner_name(const unsigned int i, const Point2 &point)
    {
      std::ostringstream name;
      name << "corner " << i + 1 << " (" << point[0] << " " << point[1] << ")";
      return name.str();
    }

    template <typename... T>
    [[noreturn]] void refuse(const T &...parts)
    {
      std::ostringstream message;
      (message << ... << parts);
      throw std::invalid_argument(message.str());
    }

    // How much of the edges next to a corner its fillet takes: radius tan(|turn|/2), without loss of digits.
    double setback(const Tensor1 &before, const Tensor1 &after, const double radius)
    {
      const double turn_sine = std::abs(cross(before, after));
      return turn_sine <= smallest_turn ? 0. : radius * turn_sine / (1. + before * after);
    }
  } // namespace


  void Shape::build(const std::vector<Point2> &points, const std::vector<double> &radii, const End start, const End end)
  {
    closed_ = false;
    start_ = start;
    end_ = end;
    if (points.size() < 2)
      refuse("A profile needs at least two points.");
    for (const auto &[what, point] : {std::make_pair(start, points.front()), std::make_pair(end, points.back())})
      if (what == End::axis && point[0] != 0.)
        refuse("An end of a profile that is said to be on the axis has r = ", point[0], ".");
    assemble(points, radii);
  }


  void Shape::build_closed(const std::vector<Point2> &points, const std::vector<double> &radii)
  {
    closed_ = true;
    start_ = end_ = End::free;
    if (points.size() < 3)
      refuse("A closed profile needs at least three points.");
    assemble(points, radii);
  }


  void Shape::assemble(const std::vector<Point2> &points, const std::vector<double> &radii)
  {
    segments_.clear();
    free_ends_.clear();
    const unsigned int n = static_cast<unsigned int>(points.size()), n_edges = closed_ ? n : n - 1;
    if (radii.size() != n)
      refuse("There are ", n, " points, but ", radii.size(), " fillet radii.");

    std::vector<Tensor1> tangents(n_edges);
    std::vector<double> lengths(n_edges), setbacks(n, 0.);
    for (unsigned int e = 0; e < n_edges; ++e)
    {
      const unsigned int next = (e + 1) % n;
      const Tensor1 edge = points[next] - points[e];
      lengths[e] = edge.norm();
      if (!std::isfinite(lengths[e]))
        refuse("A coordinate of ", corner_name(e, points[e]), " or the next is not a number.");
      if (lengths[e] == 0.)
        refuse("The points ", e + 1, " and ", next + 1, " coincide at (", points[e][0], " ", points[e][1], ").");
      tangents[e] = direction_of(edge, lengths[e]);
    }

    const auto is_corner = [&](const unsigned int i) { return closed_ || (i > 0 && i + 1 < n); };
    const auto before = [&](const unsigned int i) { return tangents[(i + n_edges - 1) % n_edges]; };
    for (unsigned int i = 0; i < n; ++i)
      if (is_corner(i))
      {
        if (!(radii[i] >= 0.) || radii[i] == infinity)
          refuse("The fillet radius ", radii[i], " at ", corner_name(i, points[i]), " must be a number >= 0.");
        if (before(i) * tangents[i] < 0 && std::abs(cross(before(i), tangents[i])) <= smallest_turn)
          refuse("The profile turns back on itself at ", corner_name(i, points[i]), ".");
        setbacks[i] = setback(before(i), tangents[i], radii[i]);
      }

    for (unsigned int e = 0; e < n_edges; ++e)
    {
      const unsigned int next = (e + 1) % n, worse = setbacks[e] >= setbacks[next] ? e : next;
      if (setbacks[e] + setbacks[next] > lengths[e] * (1 + length_tolerance))
        refuse("The fillet radius ",
               radii[worse],
               " at ",
               corner_name(worse, points[worse]),
               " does not fit: the edge between points ",
               e + 1,
               " and ",
               next + 1,
               " is ",
               lengths[e],
               " long, but its fillets need ",
               setbacks[e] + setbacks[next],
               ".");
    }

    const auto add_corner = [&](const unsigned int i) {
      const Tensor1 a = before(i), b = tangents[i];
      add_arc(points[i] - setbacks[i] * a, points[i] + setbacks[i] * b, a, b, radii[i]);
    };

    // A half corner where the profile leaves or meets the axis at an angle; the other half is its mirror image.
    const Tensor1 outward = Point2(1., 0.);
    if (start_ == End::axis)
      add_arc(points.front(), points.front(), outward, tangents.front(), 0.);
    if (closed_)
      add_corner(0);
    for (unsigned int e = 0; e < n_edges; ++e)
    {
      const unsigned int next = (e + 1) % n;
      if (lengths[e] - setbacks[e] - setbacks[next] > length_tolerance * lengths[e])
        add_line(points[e] + setbacks[e] * tangents[e], points[next] - setbacks[next] * tangents[e], tangents[e]);
      if (is_corner(next) && next != 0)
        add_corner(next);
    }
    if (end_ == End::axis)
      add_arc(points.back(), points.back(), tangents.back(), -outward, 0.);

    const auto finish_end = [&](const End what, Segment &segment, const Point2 &point, const double sign) {
      if (what == End::free)
        free_ends_.push_back(point);
      else if (what == End::endless)
      {
        if (segment.kind != Segment::Kind::line)
          refuse("A profile that goes on for ever must end with a line.");
        (sign < 0 ? segment.first : segment.last) = sign * infinity;
        for (unsigned int d = 0; d < 2; ++d)
          if (segment.tangent[d] != 0.)
            (sign * segment.tangent[d] < 0 ? segment.lower : segment.upper)[d] =
              std::copysign(infinity, sign * segment.tangent[d]);
      }
    };
    if (!closed_)
    {
      finish_end(start_, segments_.front(), points.front(), -1.);
      finish_end(end_, segments_.back(), points.back(), 1.);
    }
  }


  void Shape::add_line(const Point2 &start, const Point2 &end, const Tensor1 &tangent)
  {
    Segment line;
    line.kind = Segment::Kind::line;
    line.start = start;
    line.end = end;
    line.tangent = tangent;
    line.length = (end - start) * tangent;
    line.arc_start = length();
    line.first = -length_tolerance * line.length;
    line.last = line.length * (1. + length_tolerance);
    line.lower = Point2(std::min(start[0], end[0]), std::min(start[1], end[1]));
    line.upper = Point2(std::max(start[0], end[0]), std::max(start[1], end[1]));
    segments_.push_back(line);
  }


  void Shape::add_arc(const Point2 &start,
                      const Point2 &end,
                      const Tensor1 &tangent_before,
                      const Tensor1 &tangent_after,
                      const double radius)
  {
    const double turn = std::atan2(cross(tangent_before, tangent_after), tangent_before * tangent_after);
    if (std::abs(turn) <= smallest_turn)
      return;

    Segment arc;
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
    arc.arc_start = length();

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
    segments_.push_back(arc);
  }
} // namespace deltaform
