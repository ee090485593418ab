#pragma once

#include <deltaform/assembly/types.h>

namespace deltaform
{
  /**
   * Where blanks, contact and loads put their residual R = f_int - f_ext and its derivative dR/dq. What becomes of
   * constrained, multiplier and tool-travel unknowns is the target's business.
   */
  class AssemblyTarget
  {
  public:
    virtual ~AssemblyTarget() = default;

    /**
     * Add to the residual and, when @p matrix is not null, to the tangent.
     * @param dofs   n numbers of unknowns
     * @param matrix n x n, row-major, matrix[i * n + j] = dR_i/dq_j, or null
     * @param vector n residuals
     */
    virtual void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) = 0;

    /// Is the tangent wanted in this pass? If not, callers pass a null matrix and need not compute it.
    virtual bool wants_tangent() const = 0;
  };
} // namespace deltaform
