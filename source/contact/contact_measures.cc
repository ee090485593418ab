// What the accepted contact says about the surface: pressures, and how well the mesh follows a tool.
#include <deltaform/contact/contact_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Of each group of points (ContactProjector::group()): is a node of it pressed? Only there areas are needed.
    std::vector<bool> groups_at_pressed_nodes(const ContactInterface &contact,
                                              const std::vector<ContactPointState> &points)
    {
      const unsigned int n = contact.projector().group();
      std::vector<bool> result(points.size() / n);
      contact.projector().for_near_points([&](const unsigned int i) {
        if (points[i].touching)
          result[i / n] = true;
      });
      const auto &edges = contact.projector().edges();
      if (contact.projector().surface().points_per_edge() == 0)
        return result;
      std::vector<bool> pressed(contact.projector().surface().n_nodes());
      const auto mark = [&](const unsigned int e, const auto &action) {
        for (const unsigned int node : edges[e])
          if (node != invalid_index)
            action(node);
      };
      for (unsigned int e = 0; e < edges.size(); ++e)
        if (result[e])
          mark(e, [&](const unsigned int node) { pressed[node] = true; });
      for (unsigned int e = 0; e < edges.size(); ++e)
        mark(e, [&](const unsigned int node) { result[e] = result[e] || pressed[node]; });
      return result;
    }
  } // namespace


  std::vector<double> contact_pressure(const ContactInterface &contact,
                                       const std::vector<ContactPointState> &points,
                                       const Vector &q,
                                       const std::size_t n_nodes)
  {
    std::vector<double> force(n_nodes, 0.), area(n_nodes, 0.);
    const std::vector<bool> concerned = groups_at_pressed_nodes(contact, points);
    const unsigned int n = contact.projector().group();
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      if (!concerned[i / n])
      {
        i += n - 1;
        continue;
      }
      const ContactPoint point = contact.projector().accepted_point(q, i, points);
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


  void add_contact_pressure(const ContactInterface &contact,
                            const std::vector<ContactPointState> &points,
                            const Vector &q,
                            FaceValues &pressure)
  {
    auto &side = pressure[static_cast<unsigned int>(contact.tool().side())];
    const unsigned int n_nodes = contact.projector().surface().n_nodes();
    side.resize(n_nodes, 0.);
    const std::vector<double> own = contact_pressure(contact, points, q, n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      side[i] += own[i];
  }


  double largest_pressure_change(const ContactInterface &contact)
  {
    // A nodal pressure is a mean of those of the points.
    double largest = 0.;
    contact.projector().for_near_points([&](const unsigned int i) {
      const ContactPointState &before = contact.committed()[i], &now = contact.trial()[i];
      const double first = before.touching ? before.force : 0., last = now.touching ? now.force : 0.;
      if (first != last)
        largest = std::max(largest, std::abs(last - first) / (now.touching ? now.area : before.area));
    });
    return largest;
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
      const double ka = project(a).curvature, kb = project(b).curvature, k = std::max(std::abs(ka), std::abs(kb));
      error = std::max(error,
                       square * (m == invalid_index && per_edge == 0
                                   ? k / 8.
                                   : std::abs(ka - kb) / (72. * std::sqrt(3.)) + square * k * k * k / 512.));
    }
    return error > 0 ? std::clamp(.05 * error, 1e-6 * thickness, 1e-2 * thickness) : 1e-3 * thickness;
  }
} // namespace deltaform
