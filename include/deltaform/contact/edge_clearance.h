#pragma once

#include <deltaform/assembly/contact_surface.h>

#include <array>

namespace deltaform
{
  /// How far an edge was from touching when it was looked at, and where it was.
  struct EdgeClearance
  {
    double clearance = -1; ///< so far each of its points may go and stay clear; not positive: nothing is known
    double offset = 0; ///< largest one of its points, which the clearance has taken into account
    Tensor1 shift; ///< of the tool
    std::array<double, ContactPoint::max_dofs> values{}; ///< of the unknowns
    std::array<DofIndex, ContactPoint::max_dofs> dofs{};
    unsigned int n_dofs = 0;
    unsigned int edge = 0;

    /// What is certainly left of it at @p q plus @p step, if there is one, with the tool at @p now.
    double
    left(const ContactSurface &surface, Side side, const Vector &q, const Vector *step, const Tensor1 &now) const;
  };
} // namespace deltaform
