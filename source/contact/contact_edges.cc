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
    /// Does an edge touch the tool in the accepted state?
    bool touches(const ContactInterface &contact, const unsigned int e)
    {
      const auto &points = contact.committed();
      const unsigned int n = contact.projector().surface().points_per_edge();
      if (n > 0)
        return std::any_of(&points[e * n], &points[e * n] + n, [](const auto &point) { return point.touching; });
      const auto [a, b, m] = contact.projector().edges()[e];
      return points[a].touching || points[b].touching || (m != invalid_index && points[m].touching);
    }


    /// An edge of the blank over the tool in the accepted state, from end to end.
    struct EdgeOverTool
    {
      EdgeOverTool(const ContactInterface &contact,
                   const Vector &undeformed,
                   const Vector &q,
                   const unsigned int e)
      {
        const auto &points = contact.committed();
        const ContactProjector &projector = contact.projector();
        const unsigned int n = projector.surface().points_per_edge();
        std::array<unsigned int, 2> outermost{{e * n, (e + 1) * n - 1}};
        any_touches = touches(contact, e);
        if (n == 0)
        {
          const auto &[a, b, m] = projector.edges()[e];
          outermost = {{a, b}};
          // A node without area has no contact: on the axis contact does not end.
          contact_ends = points[a].area > 0 && points[b].area > 0 && points[a].touching != points[b].touching;
        }
        else
        {
          bool any_is_free = false;
          for (unsigned int i = e * n; i < (e + 1) * n; ++i)
            any_is_free |= points[i].area > 0 && !points[i].touching;
          contact_ends = any_touches && any_is_free;
        }
        ContactPoint place;
        projector.locate(q, outermost[0], place);
        // That of the tool: points of a far edge are not where they were accepted last.
        const Tensor1 way = contact.travel(q) * contact.tool().direction();
        offset = place.offset;
        const auto locate = [&](const Vector &at, const unsigned int k) -> const Point2 & {
          n == 0 ? projector.locate(at, outermost[k], place) : projector.locate(at, e, k, place);
          return place.x;
        };
        std::array<Point2, 2> X;
        for (const unsigned int k : {0, 1})
        {
          const unsigned int i = outermost[k];
          X[k] = locate(undeformed, k);
          ends[k] = n == 0 ? points[i].position : locate(q, k) - way;
          closest[k] = projector.look(i, ends[k]);
          touching[k] = points[i].touching;
        }
        undeformed_length = X[0].distance(X[1]);
        length = ends[0].distance(ends[1]);
      }

      Point2 at(const double share) const
      {
        return ends[0] + share * (ends[1] - ends[0]);
      }

      std::array<Point2, 2> ends; ///< relative to the tool
      std::array<Projection, 2> closest;
      std::array<bool, 2> touching;
      bool any_touches = false, contact_ends = false;
      double undeformed_length, length;
      double offset; ///< of the face from the middle of a sheet, on which the edge lies
    };


    /// Smallest radius of the tool that an edge touches or is about to touch, also between its ends; 0: a sharp corner;
    /// infinity: none.
    double radius_along(const ContactInterface &contact, const EdgeOverTool &edge, const bool smooth)
    {
      double radius = std::numeric_limits<double>::infinity();
      for (const unsigned int k : {0, 1})
      {
        const Projection &closest = edge.closest[k];
        // Twice the height of the arc over the edge: before the nodes come so near, the middle may have touched.
        const double near = .25 * edge.length * edge.length * std::abs(closest.curvature);
        // That of the curve through the end of the edge; of one around a sharp corner the distance to it.
        const double own = 1. / std::abs(closest.curvature);
        if (smooth && own <= closest.distance * (1. + 1e-9))
          continue;
        if (closest.curvature != 0. && (edge.touching[k] || closest.distance - edge.offset < near))
          radius = std::min(radius, own);
      }
      // Ends on the straights beside an arc do not see it, nor do those on large arcs beside a small one.
      if (!std::isfinite(edge.closest[0].distance) || !std::isfinite(edge.closest[1].distance))
        return radius;
      const double between =
        smallest_radius(contact.tool().shape(), edge.closest[0].arc_length, edge.closest[1].arc_length);
      if (!(between + edge.offset < radius) || (between == 0. && smooth))
        return radius;
      const double nearness = .25 * edge.length * std::min(1., edge.length / between);
      bool near = edge.touching[0] && edge.touching[1];
      constexpr unsigned int n_samples = 8;
      for (unsigned int k = 1; k < n_samples && !near; ++k)
      {
        const Projection closest = contact.tool().project(edge.at(k / static_cast<double>(n_samples)), 0.);
        near = closest.curvature != 0. && closest.distance - edge.offset < nearness;
      }
      return near ? between + edge.offset : radius;
    }


    /// Does a straight edge overlap with the tool although none of its points touches?
    bool missed(const ContactInterface &contact, const EdgeOverTool &edge)
    {
      if (edge.any_touches || edge.closest[0].distance > edge.length)
        return false;
      constexpr unsigned int n_samples = 8;
      for (unsigned int k = 0; k <= n_samples; ++k)
        if (contact.tool().project(edge.at(k / static_cast<double>(n_samples)), 0.).distance < edge.offset)
          return true;
      return false;
    }
  } // namespace


  void clamp_edges(const ContactInterface &contact, std::vector<bool> &clamped)
  {
    const unsigned int n = contact.projector().edges().size();
    clamped.resize(n, false);
    for (unsigned int e = 0; e < n; ++e)
      if (touches(contact, e))
        for (unsigned int k = std::max(e, 1U) - 1; k < std::min(e + 2, n); ++k)
          clamped[k] = true;
  }


  void shorten_edges(const ContactInterface &contact,
                     const Vector &q,
                     const EdgeWishes &wishes,
                     std::vector<double> &longest)
  {
    longest.resize(contact.projector().edges().size(), std::numeric_limits<double>::infinity());
    const Vector undeformed(contact.projector().surface().n_contact_dofs());
    constexpr double share_of_clamped = .6; // doc/decisions, Elements that are too long
    const double sharpest = wishes.share * smallest_radius(contact.tool().shape());
    for (unsigned int e = 0; e < longest.size(); ++e)
    {
      const double share = e < wishes.clamped.size() && wishes.clamped[e] ? share_of_clamped : 1.;
      if (e < wishes.lengths.size() && wishes.lengths[e] < share * sharpest)
        continue;
      const EdgeOverTool edge(contact, undeformed, q, e);
      if ((wishes.at_rim && edge.contact_ends) || (!wishes.smooth && missed(contact, edge)))
        longest[e] = 0.;
      if (wishes.share == 0. || longest[e] == 0.)
        continue;
      // The tool's radius is to be compared with the length that the edge has now; forging stretches it many times.
      const double radius = radius_along(contact, edge, wishes.smooth);
      if (radius < std::numeric_limits<double>::infinity())
        longest[e] = std::min(longest[e], share * wishes.share * radius * edge.undeformed_length / edge.length);
    }
  }
} // namespace deltaform
