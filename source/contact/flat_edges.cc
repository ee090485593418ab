#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/flat_edges.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    // Shares of delta by which an edge may be deeper between its outermost points than these: where it begins, and
    // where it ends in an increment.
    constexpr double flat_enough = .1, no_longer = .25;

    // So often in an increment edges wake alone.
    constexpr unsigned int alone = 2;

    /// The points of an edge over the tool.
    class Face
    {
    public:
      Face(const ContactProjector &projector, const FlatEdges::Points &points, const unsigned int edge)
        : projector_(projector), points_(points), first_(edge * projector.group()),
          last_(first_ + projector.group() - 1), begin_(look(first_)), end_(look(last_))
      {
      }

      bool on_straight_part() const
      {
        return begin_.curvature == 0. && end_.curvature == 0. && begin_.segment == end_.segment &&
               begin_.normal * end_.normal > 1. - 1e-12;
      }

      bool touches_inside() const
      {
        return std::any_of(points_.begin() + first_ + 1, points_.begin() + last_,
                           [](const ContactPointState &state) { return state.touching; });
      }

      bool ends_touch() const
      {
        return points_[first_].touching || points_[last_].touching;
      }

      /// By how much the deepest point between the ends is deeper than a straight line through them (length).
      double bulge() const
      {
        const bool straight = on_straight_part();
        const Point2 &start = points_[first_].position;
        const double length = start.distance(points_[last_].position), rise = end_.distance - begin_.distance;
        double result = 0.;
        for (unsigned int i = first_ + 1; i < last_; ++i)
        {
          const Tensor1 way = points_[i].position - start;
          const double own = straight ? way * begin_.normal : look(i).distance - begin_.distance;
          result = std::max(result, way.norm() / length * rise - own);
        }
        return result;
      }

    private:
      Projection look(const unsigned int i) const
      {
        return projector_.look(i, points_[i].position);
      }

      const ContactProjector &projector_;
      const FlatEdges::Points &points_;
      unsigned int first_, last_;
      Projection begin_, end_;
    };
  } // namespace


  void FlatEdges::find(const ContactProjector &projector,
                       const std::vector<unsigned int> &edges,
                       const Points &points,
                       const double delta)
  {
    if (projector.group() < 3)
      return;
    flat_.resize(points.size() / projector.group(), false);
    for (const unsigned int e : edges)
    {
      const Face face(projector, points, e);
      flat_[e] = face.on_straight_part() && !face.touches_inside() && face.bulge() <= flat_enough * delta;
    }
  }


  unsigned int FlatEdges::wake(const ContactProjector &projector, const Points &trial)
  {
    std::vector<unsigned int> woken;
    if (flat_.empty())
      return 0;
    for (const unsigned int e : projector.near_edges())
      if (flat_[e])
        if (const Face face(projector, trial, e);
            face.ends_touch() && face.bulge() > no_longer * trial[e * projector.group()].delta)
        {
          flat_[e] = false;
          woken.push_back(e);
        }
    if (!woken.empty() && ++n_wakings_ > alone)
      wake_neighbours(projector, trial, woken);
    return woken.size();
  }


  void FlatEdges::wake_neighbours(const ContactProjector &projector,
                                  const Points &trial,
                                  const std::vector<unsigned int> &woken)
  {
    const double reach = std::ldexp(1., static_cast<int>(n_wakings_ - alone)); // lengths of an edge
    const unsigned int n = projector.group();
    const auto begin = [&](const unsigned int e) { return trial[e * n].position; };
    for (const unsigned int e : projector.near_edges())
      if (flat_[e])
        flat_[e] = std::none_of(woken.begin(), woken.end(), [&](const unsigned int other) {
          const double length = begin(other).distance(trial[other * n + n - 1].position);
          return begin(e).distance(begin(other)) < reach * length;
        });
  }


  std::vector<bool> FlatEdges::were_flat(const Points &points, const unsigned int per_edge)
  {
    std::vector<bool> result(points.size() / per_edge, false);
    for (unsigned int e = 0; e < result.size(); ++e)
      result[e] = was_flat(points, per_edge, e);
    return result;
  }


  void
  FlatEdges::describe(const ContactSurface &surface, const Side side, const unsigned int i, ContactPoint &point) const
  {
    const unsigned int n = surface.points_per_edge();
    if (n > 0 && contains(i / n))
      describe_on_flat(surface, side, i, point);
  }


  void FlatEdges::describe_on_flat(const ContactSurface &surface,
                                   const Side side,
                                   const unsigned int i,
                                   ContactPoint &point)
  {
    const unsigned int n = surface.points_per_edge();
    if (i % n != 0 && i % n != n - 1)
    {
      point.area = point.compliance = 0.;
      return;
    }
    const double share = .5 / surface.point_weight(side, i);
    point.area *= share;
    point.compliance /= share;
  }
} // namespace deltaform
