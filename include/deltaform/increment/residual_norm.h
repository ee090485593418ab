#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/solver/system.h>

#include <vector>

namespace deltaform
{
  /**
   * How far equations are from balance: the norm of their residual over that of the sums of absolute contributions to
   * each row. Forces below the round-off of what they are computed from, and below a floor, are no scale
   * (doc/theory/solver.md, "Convergence").
   */
  class ResidualNorm
  {
  public:
    /**
     * All references have to outlive it. @param scale, size see Newton
     * @param is_prescribed unknowns whose rows do not count
     * @param floor     the least norm of forces to measure by
     * @param tolerance a residual of this share of the scale is no round-off
     */
    ResidualNorm(const System &system, const std::vector<double> &scale, const std::vector<double> &size,
                 const std::vector<bool> &is_prescribed, double floor, double tolerance);

    /// Of the last assembly, relative. Remembers its scale and the worst unknown.
    double relative();

    /// What the last one is relative to (force).
    double magnitude() const
    {
      return magnitude_;
    }

    /// With the largest share of the last one.
    unsigned int worst_dof() const
    {
      return worst_dof_;
    }

  private:
    const System &system_;
    const std::vector<double> &scale_, &size_;
    const std::vector<bool> &is_prescribed_;
    double floor_, tolerance_, magnitude_ = 0.;
    unsigned int worst_dof_ = invalid_index;
  };
} // namespace deltaform
