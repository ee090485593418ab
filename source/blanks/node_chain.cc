#include "node_chain.h"

namespace deltaform
{
  void NodeChain::set_up(const unsigned int n_nodes, const std::vector<std::array<unsigned int, 3>> &edges)
  {
    neighbours_.assign(n_nodes, {{invalid_index, invalid_index}});
    const auto join = [&](const unsigned int a, const unsigned int b) {
      neighbours_[a][1] = b;
      neighbours_[b][0] = a;
    };
    for (const auto &[a, b, middle] : edges)
      if (middle == invalid_index)
        join(a, b);
      else
      {
        join(a, middle);
        join(middle, b);
      }
  }


  ContactSurface::FaceDirection
  NodeChain::direction(const ContactPoint &before, const ContactPoint &point, const ContactPoint &after)
  {
    // The derivative is the mean of both differences, of which that over the shorter way counts more.
    const double first = before.x.distance(point.x), second = point.x.distance(after.x);
    const double a = second / first / (first + second), b = first / second / (first + second);
    const Tensor1 rate = a * (point.x - before.x) + b * (after.x - point.x);
    const double growth = a * (point.offset - before.offset) + b * (after.offset - point.offset);
    return {rate / rate.norm(), growth / rate.norm()};
  }
} // namespace deltaform
