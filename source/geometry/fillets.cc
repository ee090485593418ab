#include "turn.h"

#include <deltaform/geometry/fillets.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    // Component by component, because deal.II multiplies by the inverse, and (1, 0) must stay exactly that.
    Tensor1 direction_of(const Tensor1 &edge, const double length)
    {
      Tensor1 direction;
      direction[0] = edge[0] / length;
      direction[1] = edge[1] / length;
      return direction;
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

    // radius tan(|turn|/2), without loss of digits.
    double setback_of(const Tensor1 &before, const Tensor1 &after, const double radius)
    {
      const double turn_sine = std::abs(cross(before, after));
      return turn_sine <= smallest_turn ? 0. : radius * turn_sine / (1. + before * after);
    }
  } // namespace


  FilletedCorners::FilletedCorners(const std::vector<Point2> &points,
                                   const std::vector<double> &radii,
                                   const bool closed)
    : closed_(closed), setbacks_(points.size(), 0.)
  {
    const unsigned int n = n_points(), least = closed ? 3 : 2;
    if (n < least)
      refuse(closed ? "A closed profile needs at least three points." : "A profile needs at least two points.");
    if (radii.size() != n)
      refuse("There are ", n, " points, but ", radii.size(), " fillet radii.");
    for (unsigned int e = 0; e < (closed ? n : n - 1); ++e)
    {
      const unsigned int next = (e + 1) % n;
      const Tensor1 edge = points[next] - points[e];
      lengths_.push_back(edge.norm());
      if (!std::isfinite(lengths_[e]))
        refuse("A coordinate of ", corner_name(e, points[e]), " or the next is not a number.");
      if (lengths_[e] == 0.)
        refuse("The points ", e + 1, " and ", next + 1, " coincide at (", points[e][0], " ", points[e][1], ").");
      tangents_.push_back(direction_of(edge, lengths_[e]));
    }
    for (unsigned int i = 0; i < n; ++i)
      if (is_corner(i))
      {
        check_corner(i, points[i], radii[i]);
        setbacks_[i] = setback_of(tangent_before(i), tangents_[i], radii[i]);
      }
    for (unsigned int e = 0; e < n_edges(); ++e)
      check_edge(e, points, radii);
  }


  void FilletedCorners::check_corner(const unsigned int i, const Point2 &point, const double radius) const
  {
    if (!(radius >= 0.) || radius == std::numeric_limits<double>::infinity())
      refuse("The fillet radius ", radius, " at ", corner_name(i, point), " must be a number >= 0.");
    const Tensor1 &before = tangent_before(i);
    if (before * tangents_[i] < 0 && std::abs(cross(before, tangents_[i])) <= smallest_turn)
      refuse("The profile turns back on itself at ", corner_name(i, point), ".");
  }


  void FilletedCorners::check_edge(const unsigned int e,
                                   const std::vector<Point2> &points,
                                   const std::vector<double> &radii) const
  {
    const unsigned int next = (e + 1) % n_points(), worse = setbacks_[e] >= setbacks_[next] ? e : next;
    if (setbacks_[e] + setbacks_[next] > lengths_[e] * (1 + length_tolerance))
      refuse("The fillet radius ",
             radii[worse],
             " at ",
             corner_name(worse, points[worse]),
             " does not fit: the edge between points ",
             e + 1,
             " and ",
             next + 1,
             " is ",
             lengths_[e],
             " long, but its fillets need ",
             setbacks_[e] + setbacks_[next],
             ".");
  }


  double FilletedCorners::straight(const unsigned int edge) const
  {
    const double rest = lengths_[edge] - setbacks_[edge] - setbacks_[(edge + 1) % n_points()];
    return rest > length_tolerance * lengths_[edge] ? rest : 0.;
  }
} // namespace deltaform
