#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/geometry/curve.h>
#include <deltaform/io/archive.h>
#include <deltaform/parameters/scene_error.h>

#include <array>
#include <vector>

namespace deltaform
{
  class ContactProjector;
  class PointRows;

  /**
   * Contact points that move, one in each edge: to the place xi (0 to 1) where
   *
   *   G(xi) = g(xi) + c/2 ((xi - 1/2)^2 - 1/4)
   *
   * is least. g is the gap; c makes G convex, and keeps the point from running along an edge that follows the tool. G
   * is g at both ends, so that neighbours agree at their node. Contact sees G as the gap: its derivative is that of g
   * at a fixed place (doc/theory/contact.md, "A point that moves").
   */
  class MovingPoints
  {
  public:
    /// There is one in each of @p edges, in its middle; without edges points do not move.
    void reset(const std::vector<std::array<unsigned int, 3>> &edges);

    bool used() const
    {
      return !edges_.empty();
    }

    /// Where it is in edge @p e, and where it was accepted.
    ///@{
    double place(const unsigned int e) const
    {
      return edges_[e].place;
    }
    double accepted(const unsigned int e) const
    {
      return edges_[e].accepted;
    }
    ///@}

    /// g - G at a place of edge @p e (length).
    double lift(unsigned int e, double xi) const;

    /// How far its place in the sheet is from the one that was accepted, both where the increment began: a length along
    /// the tool, as slip is. 0 of points that do not move.
    double own_way(const unsigned int e) const
    {
      return used() ? edges_[e].own_way : 0.;
    }

    /// An assembly at @p q begins, with the counterpart at @p shift: move the points, if they do. One that touches at
    /// the end of its edge leaves its force to the point inside of the edge beyond, if that is free: both would meet at
    /// the node, and only one of them goes on. @p at_start: the increment begins, and with it c and which edges lie
    /// over a straight part of the tool, where the point rests in the middle
    void follow(const ContactProjector &projector,
                const Vector &q,
                const Tensor1 &shift,
                bool at_start,
                std::vector<ContactPointState> &trial);

    /// The edge beyond that end of edge @p e at which its point is; invalid_index: it is not at an end, or there is
    /// none.
    unsigned int beyond(unsigned int e) const;

    /// Does the point of edge @p e move, and is it in its edge, not at its end or at rest?
    bool is_inside(const unsigned int e) const
    {
      return used() && edges_[e].softness > 0.;
    }

    /// Add what the motion of a point that is inside adds to the tangent of its force @p lambda at its closest point.
    void add_gradient(const ContactProjector &projector,
                      unsigned int e,
                      const Vector &q,
                      const Projection &closest,
                      double lambda,
                      PointRows &rows) const;

    /// The places are accepted.
    void accept();

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      const std::size_t n = edges_.size();
      archive_plain(archive, edges_);
      if (edges_.size() != n)
        throw SceneError("The saved state has another number of contact points: it is damaged. Start again.");
    }

  private:
    void begin_increment(const ContactProjector &projector, const Vector &q, const Tensor1 &shift, double delta);
    void settle(const ContactProjector &projector, unsigned int e, const Vector &q, const Tensor1 &shift);

    /// The edge whose point takes over from that of edge @p e; invalid_index: none.
    unsigned int successor(unsigned int e, const std::vector<ContactPointState> &trial) const;

    struct Edge
    {
      double place = .5, accepted = .5;
      double c = 0; ///< see the class; 0: the point rests
      double softness = 0; ///< 1/G'' at a place that is not an end
      double own_way = 0;
    };

    std::vector<Edge> edges_;
    std::vector<std::array<unsigned int, 2>> neighbours_; ///< at both ends; invalid_index: none
  };
} // namespace deltaform
