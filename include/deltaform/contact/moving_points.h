#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/geometry/curve.h>
#include <deltaform/io/archive.h>
#include <deltaform/parameters/scene_error.h>

#include <array>
#include <vector>

namespace deltaform
{
  class ContactProjector;

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
    /// the tool, as slip is.
    double own_way(const unsigned int e) const
    {
      return edges_[e].own_way;
    }

    /// The first assembly of an increment is at @p q, with the counterpart at @p shift: c, and which edges lie over a
    /// straight part of the tool, where the point rests in the middle. @p delta: allowed penetration
    void begin_increment(const ContactProjector &projector, const Vector &q, const Tensor1 &shift, double delta);

    /// Move the point of edge @p e to its place at @p q.
    void settle(const ContactProjector &projector, unsigned int e, const Vector &q, const Tensor1 &shift);

    /// The edge beyond that end of edge @p e at which its point is; invalid_index: it is not at an end, or there is
    /// none.
    unsigned int beyond(unsigned int e) const;

    /// Is the point of edge @p e in its edge, and not at its end or at rest?
    bool is_inside(const unsigned int e) const
    {
      return edges_[e].softness > 0.;
    }

    /// What the motion adds to the tangent of a force lambda: lambda softness a a^T with a = dg'/dq, g' = dg/dxi.
    ///@{
    double softness(const unsigned int e) const
    {
      return edges_[e].softness;
    }
    struct SlopeRate
    {
      std::array<double, ContactPoint::max_dofs> own{}; ///< a at a fixed place, of the blank's unknowns
      Tensor1 by_place; ///< and what the motion of the place adds
    };
    SlopeRate slope_rate(const ContactProjector &projector,
                         unsigned int e,
                         const Vector &q,
                         const Projection &closest) const;
    ///@}

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
