#include "face_points.h"

#include <limits>

namespace deltaform
{
  namespace
  {
    Point2 middle(const Point2 &a, const Point2 &b)
    {
      return a + .5 * (b - a);
    }


    std::vector<PointOrigin> origins_of_nodes(const FacePoints &old, const FacePoints &now)
    {
      std::vector<PointOrigin> result;
      for (const Point2 &place : now.places)
      {
        PointOrigin best{0, 0, 0.};
        double nearest = std::numeric_limits<double>::infinity();
        const auto consider = [&](const unsigned int a, const unsigned int b) {
          const double distance = place.distance(middle(old.places[a], old.places[b]));
          if (distance < nearest)
          {
            nearest = distance;
            best = {a, b, a == b ? 0. : .5};
          }
        };
        for (unsigned int i = 0; i < old.places.size(); ++i)
        {
          consider(i, i);
          if (i + 1 < old.places.size())
            consider(i, i + 1);
        }
        result.push_back(best);
      }
      return result;
    }


    /// A piece of an old edge, from one share of its length to another; 2: the end of the next edge.
    struct Piece
    {
      unsigned int edge;
      double begin, end;
    };


    /// The one from @p A to @p B. @param first edge to look at: most edges are still there, so that a search which
    /// begins where the last one ended finds its piece at once.
    Piece old_piece(const FacePoints &old, const Point2 &A, const Point2 &B, const unsigned int first)
    {
      // Every other piece is as far as an edge is long.
      const double found = 1e-6 * A.distance(B);
      Piece best{0, 0., 1.};
      double nearest = std::numeric_limits<double>::infinity();
      for (unsigned int k = 0; k < old.edges.size() && nearest > found; ++k)
      {
        const unsigned int e = (first + k) % old.edges.size();
        const auto [a, b, m] = old.edges[e];
        const Point2 &start = old.places[a], &end = old.places[b];
        const Point2 half = m == invalid_index ? middle(start, end) : old.places[m];
        const auto consider = [&](const Point2 &from, const Point2 &to, const double begin, const double finish) {
          const double distance = A.distance(from) + B.distance(to);
          if (distance < nearest)
          {
            nearest = distance;
            best = {e, begin, finish};
          }
        };
        consider(start, end, 0., 1.);
        consider(start, half, 0., .5);
        consider(half, end, .5, 1.);
        if (e + 1 < old.edges.size() && old.edges[e + 1][0] == b)
          consider(start, old.places[old.edges[e + 1][1]], 0., 2.);
      }
      return best;
    }


    /// The old points, edge by edge.
    class OldPoints
    {
    public:
      explicit OldPoints(const FacePoints &face)
        : face_(face), per_edge_(face.inside.front().size())
      {
      }

      /// Of a place of an edge, from 0 to 1 of it; to 2: of the next one.
      PointOrigin at(const unsigned int edge, const double xi) const
      {
        if (xi > 1.)
          return at(edge + 1, xi - 1.);
        const auto &points = face_.inside[edge];
        const unsigned int first = edge * per_edge_;
        unsigned int next = 0;
        while (next < per_edge_ && points[next] < xi)
          ++next;
        if (next > 0 && next < per_edge_)
          return {first + next - 1, first + next, (xi - points[next - 1]) / (points[next] - points[next - 1])};
        const bool before = next == 0;
        const unsigned int own = first + (before ? 0 : per_edge_ - 1);
        const unsigned int other = neighbour(edge, before);
        if (other == invalid_index)
          return {own, own, 0.};
        // In lengths of this edge
        const double scale = length(other) / length(edge);
        if (before)
        {
          const double gap = (1. - face_.inside[other].back()) * scale;
          return between((other + 1) * per_edge_ - 1, own, xi + gap, points[0] + gap);
        }
        const double gap = 1. - points[per_edge_ - 1];
        return between(own, other * per_edge_, xi - points[per_edge_ - 1], gap + face_.inside[other].front() * scale);
      }

    private:
      /// Points at the place where two edges meet may be at the same place.
      static PointOrigin between(const unsigned int a, const unsigned int b, const double way, const double length)
      {
        return length > 0. ? PointOrigin{a, b, way / length} : PointOrigin{a, a, 0.};
      }

      /// The edge that ends where @p edge begins, or begins where it ends.
      unsigned int neighbour(const unsigned int edge, const bool before) const
      {
        const unsigned int n = face_.edges.size();
        const auto adjoins = [&](const unsigned int e) {
          return face_.edges[e][before ? 1 : 0] == face_.edges[edge][before ? 0 : 1];
        };
        // Most often the next one; where a face closes, or has parts, another.
        if (const unsigned int next = before ? edge - 1 : edge + 1; next < n && adjoins(next))
          return next;
        for (unsigned int e = 0; e < n; ++e)
          if (adjoins(e))
            return e;
        return invalid_index;
      }

      double length(const unsigned int edge) const
      {
        return face_.places[face_.edges[edge][0]].distance(face_.places[face_.edges[edge][1]]);
      }

      const FacePoints &face_;
      unsigned int per_edge_;
    };
  } // namespace


  std::vector<PointOrigin> point_origins(const FacePoints &old, const FacePoints &now)
  {
    if (old.inside.empty())
      return origins_of_nodes(old, now);
    const OldPoints points(old);
    std::vector<PointOrigin> result;
    Piece piece{0, 0., 1.};
    for (unsigned int e = 0; e < now.edges.size(); ++e)
    {
      piece = old_piece(old, now.places[now.edges[e][0]], now.places[now.edges[e][1]], piece.edge);
      for (const double xi : now.inside[e])
        result.push_back(points.at(piece.edge, piece.begin + xi * (piece.end - piece.begin)));
    }
    return result;
  }
} // namespace deltaform
