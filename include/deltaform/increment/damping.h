#pragma once

#include <deltaform/assembly/types.h>

#include <functional>
#include <vector>

namespace deltaform
{
  class System;

  /**
   * Pseudo-transient continuation, for an increment in which the blank snaps through. While a step d leads uphill
   * (d.R > 0, the tangent K is indefinite), solve with K + c M instead, M the squares of the scales: that is a step of
   * the implicit Euler method for M q' = -R, the motion of the blank in a viscous medium, of the length 1/c. The
   * solution is of the same equations; it takes many more iterations. C.T. Kelley, D.E. Keyes, Convergence analysis of
   * pseudo-transient continuation, SIAM J. Numer. Anal. 35 (1998) 508.
   */
  class Damping
  {
  public:
    /// @param scale of every unknown
    Damping(System &system, const std::vector<double> &scale);

    /// Discard the last solve.
    void restart()
    {
      c_ = 0.;
    }

    /**
     * Make a step of @p d that leads downhill.
     * @param assemble gives the system the tangent again, without damping; false if the laws cannot be evaluated
     * @param solve    factorizes it with a shift of its diagonal and computes d; false if it is singular
     * @return false if the matrix stays singular whatever the damping, or cannot be assembled
     */
    bool descend(Vector &d, const std::function<bool()> &assemble, const std::function<bool(double shift)> &solve);

    /// A step was taken. @param better its residual is smaller: less damping, in the end Newton's step again
    void relax(bool better);

    /// d.R over the unknowns that are not prescribed: what the residual does along a step.
    double work_along(const Vector &d) const;

  private:
    System &system_;
    const std::vector<double> &scale_;
    double c_ = 0.; ///< of the next iteration, force over length
  };
} // namespace deltaform
