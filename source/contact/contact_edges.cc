// Where contact wants the edges of a blank that is refined to be shorter.
#include <deltaform/contact/contact_measures.h>
#include <deltaform/geometry/curvature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Smallest radius of the tool that an edge touches or is about to touch, also between its ends; 0: a sharp corner;
    /// infinity: none.
    double radius_along(const ContactInterface &contact, const std::array<unsigned int, 3> &edge)
    {
      const auto &points = contact.committed();
      const unsigned int a = edge[0], b = edge[1];
      const Point2 &A = points[a].position, &B = points[b].position;
      const double length = A.distance(B);
      double radius = std::numeric_limits<double>::infinity();
      const std::array<Projection, 2> closest_points{{contact.projector().look(a, A), contact.projector().look(b, B)}};
      for (const unsigned int k : {0, 1})
      {
        const Projection &closest = closest_points[k];
        // Twice the height of the arc over the edge: before the nodes come so near, the middle may have touched.
        const double near = .25 * length * length * std::abs(closest.curvature);
        if (closest.curvature != 0. && (points[edge[k]].touching || closest.distance < near))
          radius = std::min(radius, 1. / std::abs(closest.curvature));
      }
      // Ends on the straights beside an arc do not see it, nor do those on large arcs beside a small one.
      if (!std::isfinite(closest_points[0].distance) || !std::isfinite(closest_points[1].distance))
        return radius;
      const double between = smallest_radius(
        contact.tool().shape(), closest_points[0].arc_length, closest_points[1].arc_length);
      if (!(between < radius))
        return radius;
      const double nearness = .25 * length * std::min(1., length / between);
      bool near = points[a].touching && points[b].touching;
      constexpr unsigned int n_samples = 8;
      for (unsigned int k = 1; k < n_samples && !near; ++k)
      {
        const Projection closest = contact.tool().project(A + (k / static_cast<double>(n_samples)) * (B - A), 0.);
        near = closest.curvature != 0. && closest.distance < nearness;
      }
      return near ? between : radius;
    }


    /// Does an edge of a solid overlap with the tool although none of its nodes touches?
    bool missed(const ContactInterface &contact, const std::array<unsigned int, 3> &edge)
    {
      const auto &points = contact.committed();
      for (const auto i : edge)
        if (i != invalid_index && points[i].touching)
          return false;
      const Point2 &A = points[edge[0]].position, &B = points[edge[1]].position;
      if (contact.projector().look(edge[0], A).distance > A.distance(B))
        return false;
      constexpr unsigned int n_samples = 8;
      for (unsigned int k = 0; k <= n_samples; ++k)
        if (contact.tool().project(A + (k / static_cast<double>(n_samples)) * (B - A), 0.).distance < 0)
          return true;
      return false;
    }
  } // namespace


  void shorten_edges(const ContactInterface &contact, const double share, const bool rim, std::vector<double> &longest)
  {
    const auto &edges = contact.projector().edges();
    const auto &points = contact.committed();
    longest.resize(edges.size(), std::numeric_limits<double>::infinity());
    const Vector undeformed(contact.projector().surface().n_contact_dofs());
    for (unsigned int e = 0; e < edges.size(); ++e)
    {
      const unsigned int a = edges[e][0], b = edges[e][1];
      const auto touching = [&](const unsigned int i) { return points[i].touching; };
      // A node without area has no contact: on the axis contact does not end.
      if ((rim && points[a].area > 0 && points[b].area > 0 && touching(a) != touching(b)) || missed(contact, edges[e]))
        longest[e] = 0.;
      if (share == 0. || longest[e] == 0.)
        continue;
      // The tool's radius is to be compared with the length that the edge has now; forging stretches it many times.
      const double radius = radius_along(contact, edges[e]);
      if (radius < std::numeric_limits<double>::infinity())
        longest[e] = std::min(longest[e],
                              share * radius * contact.point(undeformed, a).x.distance(contact.point(undeformed, b).x) /
                                points[a].position.distance(points[b].position));
    }
  }
} // namespace deltaform
