#pragma once

#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/contact_projector.h>

#include <array>
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
      edges_.assign(used && projector_.surface().points_per_edge() > 0 ? projector_.edges().size() : 0, Edge());
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
    void set(unsigned int e, const Vector &q, const Tensor1 &shift, const ContactPoint &first, double clearance);

    /// Its points have to be looked at again.
    void discard(const unsigned int e)
    {
      if (e < edges_.size())
        edges_[e].clearance = -1.;
    }

    /// Is it clear at @p q plus @p step, if there is one, with the tool at @p shift?
    bool clear(unsigned int e, const Vector &q, const Vector *step, const Tensor1 &shift) const;

  private:
    struct Edge
    {
      double clearance = -1; ///< at the unknowns below; not positive: nothing is known
      Tensor1 shift; ///< of the tool
      unsigned int n_dofs = 0;
      std::array<DofIndex, ContactPoint::max_dofs> dofs{};
      std::array<double, ContactPoint::max_dofs> values{};
    };

    const ContactProjector &projector_;
    std::vector<Edge> edges_;
  };
} // namespace deltaform
