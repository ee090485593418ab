// What the accepted contact says about the surface: pressures, and what the discretisation misses.
#include <deltaform/contact/contact_measures.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * How deep the straight line between two points that project on the same convex arc is at its deepest point. The
     * offset d grows linearly from @p d_a to @p d_b. With the center of the arc as origin the points are a and b, e =
     * b - a, and the depth at a + xi e is d_a - D_a + xi (d_b - d_a) - (rho - rho_a), rho^2 = h^2 + u^2 with the
     * distance h of the center from the line and u along it: largest where u/rho = k = (d_b - d_a)/|e|, u = h k/sqrt(1
     * - k^2).
     */
    double depth_over_arc(const Projection &a, const Projection &b, const double d_a, const double d_b)
    {
      const Tensor1 from = a.normal / a.turning, e = b.normal / b.turning - from;
      const double length = e.norm(), slope = length > 0. ? (d_b - d_a) / length : 1.;
      if (!(std::abs(slope) < 1.))
        return 0.;
      const double u_a = from * e / length, rho_a = 1. / a.turning;
      const double h = std::abs(from[0] * e[1] - from[1] * e[0]) / length;
      const double u = h * slope / std::sqrt((1. - slope) * (1. + slope));
      if (!(u > u_a) || !(u < u_a + length))
        return 0.;
      return d_a - a.distance + slope * (u - u_a) - (std::hypot(h, u) - rho_a);
    }


    /// Where contact points lie inside the edges: the deepest place of all edges that touch, by search.
    double penetration_between_points(const ContactInterface &contact, const Vector &q)
    {
      const Tensor1 shift = contact.travel(q) * contact.tool().direction();
      const auto &points = contact.committed();
      const ContactProjector &projector = contact.projector();
      const unsigned int n = projector.surface().points_per_edge();
      double deepest = 0.;
      for (unsigned int e = 0; e < projector.edges().size(); ++e)
      {
        const auto *const own = &points[e * n];
        if (std::none_of(own, own + n, [](const ContactPointState &state) { return state.touching; }))
          continue;
        // How far the face is compressed: known at the points, taken for linear between them.
        const auto squeeze = [&](const double xi) {
          const double s = std::clamp(xi * n - .5, 0., n - 1.);
          const unsigned int k = std::min(static_cast<unsigned int>(s), n - 1), l = std::min(k + 1, n - 1);
          const auto at = [&](const unsigned int g) { return own[g].touching ? own[g].compliance * own[g].force : 0.; };
          return at(k) + (s - k) * (at(l) - at(k));
        };
        const auto gap = [&](const double xi) {
          const ContactPoint place = projector.place(q, e, xi);
          return projector.look(e * n, place.x - shift).distance - place.offset + squeeze(xi);
        };
        const unsigned int n_samples = 2 * n + 2;
        double best = 0., least = std::numeric_limits<double>::infinity();
        for (unsigned int k = 0; k <= n_samples; ++k)
          if (const double xi = k / static_cast<double>(n_samples), here = gap(xi); here < least)
          {
            best = xi;
            least = here;
          }
        const double low = std::max(0., best - 1. / n_samples), high = std::min(1., best + 1. / n_samples);
        least = std::min(least, boost::math::tools::brent_find_minima(gap, low, high, 12).second);
        deepest = std::max(deepest, -least);
      }
      return deepest;
    }
  } // namespace


  std::vector<double> contact_pressure(const ContactInterface &contact, const Vector &q, const std::size_t n_nodes)
  {
    const auto &points = contact.committed();
    std::vector<double> force(n_nodes, 0.), area(n_nodes, 0.);
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const ContactPoint point = contact.point(q, i);
      for (unsigned int a = 0; a < point.n_nodes; ++a)
      {
        const auto &[node, share] = point.nodes[a];
        area[node] += share * point.area;
        if (points[i].touching)
          force[node] += share * points[i].force;
      }
    }
    for (std::size_t i = 0; i < n_nodes; ++i)
      force[i] = area[i] > 0 ? force[i] / area[i] : 0.;
    return force;
  }


  double automatic_delta(const ContactInterface &contact)
  {
    const auto &points = contact.committed();
    // A straight element cuts a curved tool by h^2 k/8, a quadratic one misses the change of the curvature, about h^2
    // dk/(72 sqrt 3), and of a circle the fourth order: h^4 k^3/512. A twentieth of the largest such error under the
    // tool, so that contact is never what the result suffers from.
    const auto project = [&](const unsigned int i) { return contact.projector().look(i, points[i].position); };
    std::vector<bool> concerned(points.size());
    bool any = false;
    double thickness = 0.;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      concerned[i] = points[i].touching;
      any |= concerned[i];
      thickness = std::max(thickness, points[i].thickness);
    }
    if (!any)
    {
      // Nothing touches yet: where it will.
      unsigned int closest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (unsigned int i = 0; i < points.size(); ++i)
        if (const double distance = project(i).distance; distance < least)
        {
          least = distance;
          closest = i;
        }
      concerned[closest] = true;
    }
    double error = 0.;
    const unsigned int per_edge = contact.projector().surface().points_per_edge(), n_points = points.size();
    for (unsigned int e = 0; e < contact.projector().edges().size(); ++e)
    {
      // Points inside the edges: from one to the next of the same kind, as far as an edge reaches. That smooth curve is
      // taken for as good as a quadratic one.
      const auto [a, b, m] =
        per_edge == 0 ? contact.projector().edges()[e]
                      : std::array<unsigned int, 3>{
                          {e * per_edge, std::min((e + 1) * per_edge, n_points - 1), invalid_index}};
      if (!concerned[a] && !concerned[b] && (m == invalid_index || !concerned[m]))
        continue;
      const double square = (points[b].position - points[a].position).norm_square();
      const double ka = project(a).turning, kb = project(b).turning, k = std::max(std::abs(ka), std::abs(kb));
      error = std::max(error,
                       square * (m == invalid_index && per_edge == 0
                                   ? k / 8.
                                   : std::abs(ka - kb) / (72. * std::sqrt(3.)) + square * k * k * k / 512.));
    }
    return error > 0 ? std::clamp(.05 * error, 1e-6 * thickness, 1e-2 * thickness) : 1e-3 * thickness;
  }


  double penetration_between_nodes(const ContactInterface &contact, const Vector &q)
  {
    if (contact.projector().surface().points_per_edge() > 0)
      return penetration_between_points(contact, q);
    const Tensor1 shift = contact.travel(q) * contact.tool().direction();
    const auto &points = contact.committed();
    double deepest = 0.;
    unsigned int last_node = invalid_index; // whose projection is
    Projection last{};
    for (const auto &edge : contact.projector().edges())
    {
      const unsigned int a = edge[0], b = edge[1], m = edge[2];
      if (!points[a].touching && !points[b].touching && (m == invalid_index || !points[m].touching))
        continue;
      const ContactPoint start = contact.point(q, a), end = contact.point(q, b);
      const ContactPoint middle = m == invalid_index ? start : contact.point(q, m);
      const double a_face = face(start, points[a]), b_face = face(end, points[b]);
      const double m_face = m == invalid_index ? 0. : face(middle, points[m]);
      const auto gap = [&](const double xi) {
        const std::array<double, 3> N =
          m == invalid_index ? std::array<double, 3>{{1 - xi, xi, 0.}}
                             : std::array<double, 3>{{(1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1), 4 * xi * (1 - xi)}};
        Point2 x = start.x - shift;
        const double offset = N[0] * a_face + N[1] * b_face + N[2] * m_face;
        x += N[1] * (end.x - start.x) + N[2] * (middle.x - start.x);
        return contact.projector().look(a, x).distance - offset;
      };
      const Projection first = last_node == a ? last : contact.projector().look(a, start.x - shift);
      last = contact.projector().look(a, end.x - shift);
      last_node = b;
      deepest = std::max({deepest, a_face - first.distance, b_face - last.distance});
      // A straight edge over one part of the tool that is straight or hollow is deepest at one of its ends.
      if (m == invalid_index && first.segment == last.segment && (start.x[0] < 0) == (end.x[0] < 0))
      {
        if (first.turning > 0. && last.turning > 0.)
          deepest = std::max(deepest, depth_over_arc(first, last, a_face, b_face));
        continue;
      }
      // Two humps are possible where a line meets an arc inside the element: search both halves.
      for (const double low : {0., .5})
        deepest = std::max(deepest, -boost::math::tools::brent_find_minima(gap, low, low + .5, 20).second);
    }
    return deepest;
  }
} // namespace deltaform
