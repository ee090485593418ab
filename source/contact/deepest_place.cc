// What delta does not say: how deep the face is in the tool between the contact points.
#include <deltaform/contact/contact_measures.h>
#include <deltaform/contact/deepest_place.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Is there a sharp convex corner of the tool, or its end, between the closest points of two places? A profile of
    /// many points turns a little at each: these are none.
    bool bends_over_corner(const Curve &curve, const Projection &a, const Projection &b)
    {
      constexpr double least_turn = .2;
      if (!std::isfinite(a.distance) || !std::isfinite(b.distance))
        return true;
      const double low = std::min(a.arc_length, b.arc_length), high = std::max(a.arc_length, b.arc_length);
      const double round_off = 1e-12 * (std::abs(low) + std::abs(high));
      const auto &segments = curve.segments();
      return std::any_of(segments.begin(), segments.end(), [&](const Segment &segment) {
        return segment.kind == Segment::Kind::arc && segment.convex && segment.radius == 0. &&
               std::abs(segment.sweep) > least_turn &&
               segment.arc_start >= low - round_off && segment.arc_start <= high + round_off;
      });
    }


    /**
     * How deep the straight line between two points that project on the same convex arc is at its deepest point, and
     * which share of the line is before it. The offset d grows linearly from @p d_a to @p d_b. With the center of the
     * arc as origin the points are a and b, e = b - a, and the depth at a + xi e is d_a - D_a + xi (d_b - d_a) - (rho -
     * rho_a), rho^2 = h^2 + u^2 with the distance h of the center from the line and u along it: largest where u/rho = k
     * = (d_b - d_a)/|e|, u = h k/sqrt(1 - k^2).
     */
    std::pair<double, double> depth_over_arc(const Projection &a, const Projection &b, const double d_a,
                                             const double d_b)
    {
      const Tensor1 from = a.normal / a.curvature, e = b.normal / b.curvature - from;
      const double length = e.norm(), slope = length > 0. ? (d_b - d_a) / length : 1.;
      if (!(std::abs(slope) < 1.))
        return {0., 0.};
      const double u_a = from * e / length, rho_a = 1. / a.curvature;
      const double h = std::abs(from[0] * e[1] - from[1] * e[0]) / length;
      const double u = h * slope / std::sqrt((1. - slope) * (1. + slope));
      if (!(u > u_a) || !(u < u_a + length))
        return {0., 0.};
      return {d_a - a.distance + slope * (u - u_a) - (std::hypot(h, u) - rho_a), (u - u_a) / length};
    }


    /// Searches the edges of one interface.
    class Search
    {
    public:
      Search(const ContactInterface &contact, const Vector &q)
        : contact_(contact), q_(q), shift_(contact.travel(q) * contact.tool().direction()),
          points_(contact.committed()), projector_(contact.projector())
      {
      }

      DeepestPlaces run()
      {
        const bool inside = projector_.surface().points_per_edge() > 0;
        if (inside)
          for (const unsigned int e : projector_.near_edges())
            search_between_points(e);
        else
          for (const auto &edge : projector_.edges())
            search_between_nodes(edge);
        return result_;
      }

    private:
      /// A place of an edge, from and to which the projections are.
      void tell(const double depth, const Projection &a, const Projection &b, const Point2 &place)
      {
        if (depth > result_.anywhere.depth)
          result_.anywhere = {depth, place};
        if (depth > result_.off_corners.depth && !bends_over_corner(contact_.tool().shape(), a, b))
          result_.off_corners = {depth, place};
      }

      const ContactPoint &locate(const unsigned int e, const double xi)
      {
        projector_.locate(q_, e, xi, place_);
        return place_;
      }

      /// Where contact points lie inside the edges: by search.
      void search_between_points(const unsigned int e)
      {
        const unsigned int n = projector_.surface().points_per_edge();
        const auto *const own = &points_[e * n];
        if (std::none_of(own, own + n, [](const ContactPointState &state) { return state.touching; }))
          return;
        const Point2 start = locate(e, 0.).x, end = locate(e, 1.).x;
        places_.clear();
        for (const auto &place : projector_.surface().points_of_edge(contact_.tool().side(), e))
          places_.push_back(place[0]);
        // How far the face is compressed: known at the points, taken for linear between them.
        const auto compression = [&](const double xi) {
          const unsigned int l = std::upper_bound(places_.begin(), places_.end(), xi) - places_.begin();
          const auto at = [&](const unsigned int g) { return own[g].touching ? own[g].compliance * own[g].force : 0.; };
          if (l == 0 || l == n)
            return at(l == 0 ? 0 : n - 1);
          const double share = (xi - places_[l - 1]) / (places_[l] - places_[l - 1]);
          return at(l - 1) + share * (at(l) - at(l - 1));
        };
        const auto look = [&](const Point2 &x) { return projector_.look(e * n, x - shift_); };
        const auto gap = [&](const double xi) {
          const ContactPoint &place = locate(e, xi);
          return look(place.x).distance - place.offset + compression(xi);
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
        if (const auto [xi, found] = boost::math::tools::brent_find_minima(gap, low, high, 12); found < least)
        {
          best = xi;
          least = found;
        }
        if (-least > 0.)
          tell(-least, look(start), look(end), locate(e, best).x);
      }

      /// Where the nodes are the contact points: edges are chords or parabolas.
      void search_between_nodes(const std::array<unsigned int, 3> &edge)
      {
        const unsigned int a = edge[0], b = edge[1], m = edge[2];
        if (!points_[a].touching && !points_[b].touching && (m == invalid_index || !points_[m].touching))
          return;
        const ContactPoint start = contact_.point(q_, a), end = contact_.point(q_, b);
        const double a_face = face(start, points_[a]), b_face = face(end, points_[b]);
        const Projection first = last_node_ == a ? last_ : projector_.look(a, start.x - shift_);
        last_ = projector_.look(a, end.x - shift_);
        last_node_ = b;
        tell(a_face - first.distance, first, last_, start.x);
        tell(b_face - last_.distance, first, last_, end.x);
        // A straight edge over one part of the tool that is straight or hollow is deepest at one of its ends.
        if (m == invalid_index && first.segment == last_.segment && (start.x[0] < 0) == (end.x[0] < 0))
        {
          if (first.curvature > 0. && last_.curvature > 0.)
          {
            const auto [depth, xi] = depth_over_arc(first, last_, a_face, b_face);
            tell(depth, first, last_, start.x + xi * (end.x - start.x));
          }
          return;
        }
        const ContactPoint middle = m == invalid_index ? start : contact_.point(q_, m);
        const double m_face = m == invalid_index ? 0. : face(middle, points_[m]);
        const auto shapes = [&](const double xi) {
          return m == invalid_index
                   ? std::array<double, 3>{{1 - xi, xi, 0.}}
                   : std::array<double, 3>{{(1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1), 4 * xi * (1 - xi)}};
        };
        const auto place = [&](const double xi) {
          const auto N = shapes(xi);
          return start.x + N[1] * (end.x - start.x) + N[2] * (middle.x - start.x);
        };
        const auto gap = [&](const double xi) {
          const auto N = shapes(xi);
          return projector_.look(a, place(xi) - shift_).distance - (N[0] * a_face + N[1] * b_face + N[2] * m_face);
        };
        // Two humps are possible where a line meets an arc inside the element: search both halves.
        for (const double low : {0., .5})
        {
          const auto [xi, least] = boost::math::tools::brent_find_minima(gap, low, low + .5, 20);
          tell(-least, first, last_, place(xi));
        }
      }

      const ContactInterface &contact_;
      const Vector &q_;
      const Tensor1 shift_; ///< of the tool
      const std::vector<ContactPointState> &points_;
      const ContactProjector &projector_;
      DeepestPlaces result_;
      unsigned int last_node_ = invalid_index; ///< whose projection is
      Projection last_{};
      ContactPoint place_; ///< located last
      std::vector<double> places_; ///< of the contact points in an edge, from 0 to 1
    };
  } // namespace


  DeepestPlaces deepest_places(const ContactInterface &contact, const Vector &q)
  {
    return Search(contact, q).run();
  }
} // namespace deltaform
