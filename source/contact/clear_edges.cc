#include <deltaform/contact/clear_edges.h>

namespace deltaform
{
  void ClearEdges::set(const unsigned int e,
                       const Vector &q,
                       const Tensor1 &shift,
                       const ContactPoint &first,
                       const double clearance,
                       const double offset)
  {
    EdgeClearance &edge = edges_[e];
    edge.clearance = clearance;
    if (!(clearance > 0))
      return;
    edge.edge = e;
    edge.offset = offset;
    edge.shift = shift;
    edge.n_dofs = first.n_dofs;
    edge.dofs = first.dofs;
    for (unsigned int k = 0; k < first.n_dofs; ++k)
      edge.values[k] = q[first.dofs[k]];
  }


  bool
  ClearEdges::clear(const unsigned int e, const Vector &q, const Vector *const step, const Tensor1 &shift) const
  {
    if (!known(e))
      return false;
    return edges_[e].left(projector_.surface(), projector_.side(), q, step, shift) > 0;
  }
} // namespace deltaform
