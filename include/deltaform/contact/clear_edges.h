#pragma once

#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/edge_clearance.h>

#include <vector>

namespace deltaform
{
  /**
   * Edges that are too far from the tool for any of their points to touch. Points inside them are not projected until
   * the edge may have moved by its clearance (ContactSurface::largest_motion()). Results are the same.
   */
  class ClearEdges
  {
  public:
    explicit ClearEdges(const ContactProjector &projector)
      : projector_(projector)
    {
    }

    /// Nothing is known. @p used: may points be left alone? Nodes never are.
    void restart(const bool used)
    {
      edges_.resize(used && projector_.surface().points_per_edge() > 0 ? projector_.edges().size() : 0);
      for (const unsigned int e : projector_.near_edges())
        discard(e);
    }

    bool used() const
    {
      return !edges_.empty();
    }

    /// Was edge @p e clear when it was looked at, and left alone since?
    bool known(const unsigned int e) const
    {
      return e < edges_.size() && edges_[e].clearance > 0;
    }

    /// The points of an edge were looked at with the unknowns @p q and the tool at @p shift. @p first: one of them;
    /// @p clearance: how far each of them may go and stay clear; not positive: the edge is not clear.
    /// @p offset: the largest of them
    void set(unsigned int e,
             const Vector &q,
             const Tensor1 &shift,
             const ContactPoint &first,
             double clearance,
             double offset);

    /// What is known of a clear edge.
    const EdgeClearance &of(const unsigned int e) const
    {
      return edges_[e];
    }

    /// Its points have to be looked at again.
    void discard(const unsigned int e)
    {
      if (e < edges_.size())
        edges_[e].clearance = -1.;
    }

    /// Is it clear at @p q plus @p step, if there is one, with the tool at @p shift?
    bool clear(unsigned int e, const Vector &q, const Vector *step, const Tensor1 &shift) const;

  private:
    const ContactProjector &projector_;
    std::vector<EdgeClearance> edges_;
  };
} // namespace deltaform
