#pragma once

#include <deltaform/loads/load.h>

#include <vector>

namespace deltaform
{
  /// Adds forces of the sizes value * weights[i] on the unknowns dofs[i]; they do not depend on the displacements.
  inline void
  add_nodal_forces(const std::vector<DofIndex> &dofs, const std::vector<double> &weights, const double value,
                   AssemblyTarget &target)
  {
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      const double residual = -value * weights[i], zero = 0.;
      target.add(&dofs[i], 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
  }
} // namespace deltaform
