#pragma once

#include <deltaform/assembly/types.h>

namespace deltaform
{
  /// Read access to the tangent of the blank while contact has not been added to it yet: K of the paper.
  class StiffnessView
  {
  public:
    virtual ~StiffnessView() = default;

    /// Entries K(dofs_i, dofs_j), row-major, n x n.
    virtual void block(const DofIndex *dofs, unsigned int n, double *result) const = 0;

    /// result = K direction, on the unknowns of the blank.
    virtual void multiply(const Vector &direction, Vector &result) const = 0;
  };
} // namespace deltaform
