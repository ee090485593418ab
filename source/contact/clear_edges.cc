#include <deltaform/contact/clear_edges.h>

namespace deltaform
{
  void ClearEdges::set(const unsigned int e,
                       const Vector &q,
                       const Tensor1 &shift,
                       const ContactPoint &first,
                       const double clearance)
  {
    Edge &edge = edges_[e];
    edge.clearance = clearance;
    if (!(clearance > 0))
      return;
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
    const Edge &edge = edges_[e];
    std::array<double, ContactPoint::max_dofs> change{};
    for (unsigned int k = 0; k < edge.n_dofs; ++k)
      change[k] = q[edge.dofs[k]] - edge.values[k] + (step != nullptr ? (*step)[edge.dofs[k]] : 0.);
    const double way = projector_.surface().largest_motion(projector_.side(), e, change);
    return way + (shift - edge.shift).norm() < edge.clearance;
  }
} // namespace deltaform
