#include <deltaform/contact/edge_clearance.h>

namespace deltaform
{
  double EdgeClearance::left(const ContactSurface &surface,
                             const Side side,
                             const Vector &q,
                             const Vector *const step,
                             const Tensor1 &now) const
  {
    std::array<double, ContactPoint::max_dofs> change{};
    for (unsigned int k = 0; k < n_dofs; ++k)
      change[k] = q[dofs[k]] - values[k] + (step != nullptr ? (*step)[dofs[k]] : 0.);
    return clearance - surface.largest_motion(side, edge, change) - (now - shift).norm();
  }
} // namespace deltaform
