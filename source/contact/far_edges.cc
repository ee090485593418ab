#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/far_edges.h>

#include <algorithm>
#include <numeric>

namespace deltaform
{
  namespace
  {
    /// An edge is far if it could go so many times as far as in the last increment. Looking at one again costs as much
    /// as it saves in an increment.
    constexpr double increments_to_come = 4.;
    constexpr double growth_in_an_increment = .02; ///< of an offset, more than any sheet thickens
  } // namespace


  void FarEdges::reset(const unsigned int n_edges)
  {
    n_edges_ = n_edges;
    far_.clear();
    find_near();
  }


  void FarEdges::find_near()
  {
    near_.resize(n_edges_ - far_.size());
    unsigned int next = 0, e = 0;
    const auto fill = [&](const unsigned int end) {
      for (; e < end; ++e)
        near_[next++] = e;
    };
    for (const EdgeClearance &edge : far_)
    {
      fill(edge.edge);
      ++e;
    }
    fill(n_edges_);
    if (far_.empty())
      least_clearance_ = std::numeric_limits<double>::infinity();
  }


  bool FarEdges::is_far(const ContactProjector &projector,
                        const EdgeClearance &edge,
                        const Vector &q,
                        const Tensor1 &shift) const
  {
    if (start_.size() != q.size())
      return false;
    const ContactSurface &surface = projector.surface();
    const double left = edge.left(surface, projector.side(), q, nullptr, shift);
    if (!(left > 0))
      return false;
    EdgeClearance increment = edge;
    increment.clearance = 0.;
    increment.shift = start_shift_;
    for (unsigned int k = 0; k < edge.n_dofs; ++k)
      increment.values[k] = start_[edge.dofs[k]];
    return left > -increments_to_come * increment.left(surface, projector.side(), q, nullptr, shift);
  }


  void FarEdges::add(const std::vector<EdgeClearance> &edges)
  {
    if (edges.empty())
      return;
    std::vector<EdgeClearance> all(far_.size() + edges.size());
    std::merge(far_.begin(), far_.end(), edges.begin(), edges.end(), all.begin(),
               [](const EdgeClearance &a, const EdgeClearance &b) { return a.edge < b.edge; });
    far_ = std::move(all);
    find_near();
  }


  template <typename IsNear>
  std::vector<unsigned int> FarEdges::take(const IsNear &is_near)
  {
    std::vector<unsigned int> result;
    least_clearance_ = std::numeric_limits<double>::infinity();
    for (EdgeClearance &edge : far_)
      if (const double left = is_near(edge); left > 0)
        least_clearance_ = std::min(least_clearance_, left);
      else
        result.push_back(edge.edge);
    if (result.empty())
      return result;
    far_.erase(std::remove_if(far_.begin(), far_.end(),
                              [&](const EdgeClearance &edge) {
                                return std::binary_search(result.begin(), result.end(), edge.edge);
                              }),
               far_.end());
    find_near();
    return result;
  }


  std::vector<unsigned int>
  FarEdges::begin_increment(const ContactProjector &projector, const Vector &q, const Tensor1 &shift)
  {
    start_ = q;
    start_shift_ = shift;
    const unsigned int n = projector.group();
    ContactPoint point;
    const auto left = [&](EdgeClearance &edge) {
      if (!dofs_known_)
      {
        projector.describe(q, edge.edge * n, point);
        edge.n_dofs = point.n_dofs;
        edge.dofs = point.dofs;
      }
      const double result = edge.left(projector.surface(), projector.side(), q, nullptr, shift);
      // The offset is another with the thickness, which is linear along the edge, and will be in this increment. Where
      // more is left than the offset the sheet would have to become twice as thick.
      if (!(result > 0) || result > edge.offset)
        return result;
      double now = 0.;
      for (const unsigned int i : {edge.edge * n, (edge.edge + 1) * n - 1})
      {
        projector.locate(q, i, point);
        now = std::max(now, point.offset);
      }
      return result - std::max(now - edge.offset, 0.) - growth_in_an_increment * now;
    };
    const std::vector<unsigned int> result = take(left);
    dofs_known_ = true;
    return result;
  }


  std::vector<unsigned int> FarEdges::approach(const ContactProjector &projector,
                                               const Vector &q,
                                               const Vector *const step,
                                               const Tensor1 &shift)
  {
    if (far_.empty())
      return {};
    return take([&](const EdgeClearance &edge) {
      return edge.left(projector.surface(), projector.side(), q, step, shift);
    });
  }


  bool FarEdges::take_loaded()
  {
    dofs_known_ = false;
    for (unsigned int i = 0; i < far_.size(); ++i)
      if (far_[i].edge >= n_edges_ || (i > 0 && far_[i].edge <= far_[i - 1].edge))
        return false;
    find_near();
    return true;
  }
} // namespace deltaform
