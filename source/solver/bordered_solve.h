#pragma once
// Solving with the border of a tangent; private to the solver.
#include <deltaform/assembly/types.h>

namespace deltaform
{
  class Factorization;
  class PrescribedRows;
  class Tangent;

  /**
   * Solve [K B; C D] d = -R, with d = @p increments on prescribed unknowns and the factorized K: the border is
   * eliminated as a block, (D - C K^-1 B) w = -R_w + C K^-1 R.
   * @return false if a number is not finite, or if the border is singular
   */
  bool solve_bordered(Factorization &factorization,
                      const Tangent &tangent,
                      const PrescribedRows &rows,
                      const Vector &residual,
                      const Vector &increments,
                      Vector &d);
} // namespace deltaform
