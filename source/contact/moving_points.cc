#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/moving_points.h>
#include <deltaform/contact/point_rows.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace deltaform
{
  namespace
  {
    // Of delta, and of the largest change of g' by the tool's curvature: c is at least as large (doc/decisions, "A
    // contact point that moves").
    constexpr double share_of_delta = .8, share_of_turn = .1;

    // G'' is taken for at least so many times c in the tangent: within an increment g'' may fall below what c allowed for.
    constexpr double least_share_of_c = .1;

    // Edges farther from the tool than so many of their lengths are not asked.
    constexpr double reach = 1.5;

    /// The gap along an edge.
    class GapAlongEdge
    {
    public:
      GapAlongEdge(const ContactProjector &projector, const unsigned int e, const Vector &q, const Tensor1 &shift)
        : projector_(projector), e_(e), q_(q), shift_(shift)
      {
        const Point2 first = locate(0.);
        const double offset = place_.offset;
        length_ = locate(1.).distance(first);
        offset_rate_ = place_.offset - offset;
      }

      double length() const
      {
        return length_;
      }

      /// Its derivatives by xi at a place.
      struct At
      {
        Projection closest;
        double slope, bend;
        double turn; ///< the share of bend that the tool's curvature has
      };

      At at(const double xi)
      {
        const Projection closest = projector_.look(e_, locate(xi) - shift_);
        const auto curve = projector_.surface().face_curve(q_, projector_.side(), e_, xi);
        const double along = closest.tangent * curve.along, turn = closest.curvature * along * along;
        return {closest, closest.normal * curve.along - offset_rate_, closest.normal * curve.bend + turn, turn};
      }

      const Point2 &locate(const double xi)
      {
        projector_.locate(q_, e_, xi, place_);
        return place_.x;
      }

      /// Offset of the place that was located last.
      double offset() const
      {
        return place_.offset;
      }

    private:
      const ContactProjector &projector_;
      unsigned int e_;
      const Vector &q_;
      const Tensor1 &shift_;
      ContactPoint place_;
      double length_, offset_rate_;
    };


    /// c of an edge; 0: over a straight part of the tool.
    double regularization(GapAlongEdge &gap, const double delta)
    {
      double largest_turn = 0., least_bend = std::numeric_limits<double>::infinity();
      bool straight = true;
      for (const double xi : {0., .25, .5, .75, 1.})
      {
        const auto here = gap.at(xi);
        straight &= !(here.closest.curvature > 0.);
        least_bend = std::min(least_bend, here.bend);
        // Around a sharp corner the curve turns by its distance, and the place of the corner is the point's.
        const bool corner = here.closest.curvature * here.closest.distance > 1. - 1e-9;
        if (!corner)
          largest_turn = std::max(largest_turn, here.turn);
      }
      return straight ? 0. : std::max(share_of_delta * delta, share_of_turn * largest_turn - least_bend);
    }


    /// Where the derivative @p rise of a convex function over [0, 1] vanishes, or an end. rise(xi) returns it with its
    /// own derivative. @param xi where the search starts
    template <typename Rise>
    double place_of_minimum(const Rise &rise, double xi)
    {
      if (rise(0.).first >= 0.)
        return 0.;
      if (rise(1.).first <= 0.)
        return 1.;
      constexpr unsigned int enough = 60; // halves arrive before
      double low = 0., high = 1.;
      for (unsigned int k = 0; k < enough; ++k)
      {
        const auto [value, derivative] = rise(xi);
        (value < 0. ? low : high) = xi;
        double next = xi - value / derivative;
        if (!(next > low && next < high))
          next = .5 * (low + high);
        if (std::abs(std::exchange(xi, next) - next) < 1e-12)
          break;
      }
      return xi;
    }
  } // namespace


  void MovingPoints::reset(const std::vector<std::array<unsigned int, 3>> &edges)
  {
    edges_.assign(edges.size(), Edge());
    neighbours_.assign(edges.size(), {{invalid_index, invalid_index}});
    std::map<unsigned int, unsigned int> ends; // of which edge a node is the last
    for (unsigned int e = 0; e < edges.size(); ++e)
      ends[edges[e][1]] = e;
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (const auto before = ends.find(edges[e][0]); before != ends.end())
      {
        neighbours_[e][0] = before->second;
        neighbours_[before->second][1] = e;
      }
  }


  double MovingPoints::lift(const unsigned int e, const double xi) const
  {
    return .5 * edges_[e].c * xi * (1. - xi);
  }


  void MovingPoints::follow(const ContactProjector &projector,
                            const Vector &q,
                            const Tensor1 &shift,
                            const bool at_start,
                            std::vector<ContactPointState> &trial)
  {
    if (!used())
      return;
    if (at_start)
      begin_increment(projector, q, shift, trial.front().delta);
    for (unsigned int e = 0; e < edges_.size(); ++e)
      settle(projector, e, q, shift);
    for (unsigned int e = 0; e < edges_.size(); ++e)
      if (trial[e].is_held())
        if (const unsigned int next = successor(e, trial); next != invalid_index)
          trial[next].take_over(trial[e]);
  }


  unsigned int MovingPoints::successor(const unsigned int e, const std::vector<ContactPointState> &trial) const
  {
    unsigned int last = e, next = beyond(e);
    const auto goes_on = [&] { return next != invalid_index && !trial[next].is_held() && !is_inside(next); };
    while (goes_on() && beyond(next) != last)
      next = beyond(std::exchange(last, next));
    return next != invalid_index && !trial[next].is_held() && is_inside(next) ? next : invalid_index;
  }


  void MovingPoints::begin_increment(const ContactProjector &projector,
                                     const Vector &q,
                                     const Tensor1 &shift,
                                     const double delta)
  {
    for (unsigned int e = 0; e < edges_.size(); ++e)
    {
      Edge &edge = edges_[e];
      GapAlongEdge gap(projector, e, q, shift);
      const Point2 x = gap.locate(edge.place) - shift;
      edge.c = projector.clear_way(e, x, gap.offset()) > reach * gap.length() ? share_of_delta * delta
                                                                              : regularization(gap, delta);
    }
  }


  void MovingPoints::settle(const ContactProjector &projector,
                            const unsigned int e,
                            const Vector &q,
                            const Tensor1 &shift)
  {
    Edge &edge = edges_[e];
    edge.softness = edge.own_way = 0.;
    GapAlongEdge gap(projector, e, q, shift);
    if (const Point2 x = gap.locate(edge.place) - shift;
        projector.clear_way(e, x, gap.offset()) > reach * gap.length())
      return;
    if (!(edge.c > 0.))
      edge.place = .5;
    else
    {
      const auto rise = [&](const double xi) {
        const auto here = gap.at(xi);
        return std::pair(here.slope + edge.c * (xi - .5), here.bend + edge.c);
      };
      edge.place = place_of_minimum(rise, edge.place);
      if (edge.place > 0. && edge.place < 1.)
        edge.softness = 1. / std::max(rise(edge.place).second, least_share_of_c * edge.c);
    }
    const FarEdges &far = projector.far();
    const auto arc_length = [&](const double xi) {
      ContactPoint start;
      projector.locate(far.start(), e, xi, start);
      return projector.look(e, start.x - far.start_shift()).arc_length;
    };
    edge.own_way = arc_length(edge.place) - arc_length(edge.accepted);
  }


  unsigned int MovingPoints::beyond(const unsigned int e) const
  {
    const double xi = edges_[e].place;
    return xi > 0. && xi < 1. ? invalid_index : neighbours_[e][xi > 0. ? 1 : 0];
  }


  void MovingPoints::add_gradient(const ContactProjector &projector,
                                  const unsigned int e,
                                  const Vector &q,
                                  const Projection &closest,
                                  const double lambda,
                                  PointRows &rows) const
  {
    const auto curve = projector.surface().face_curve(q, projector.side(), e, place(e));
    std::array<double, ContactPoint::max_dofs> own{}; // d(dg/dxi)/dq at a fixed place
    for (unsigned int k = 0; k < own.size(); ++k)
      own[k] = closest.normal * curve.jacobian[k];
    const double turn = closest.curvature * (closest.tangent * curve.along);
    rows.add_square(lambda * edges_[e].softness, own, turn * closest.tangent);
  }


  void MovingPoints::accept()
  {
    for (Edge &edge : edges_)
      edge.accepted = edge.place;
  }
} // namespace deltaform
