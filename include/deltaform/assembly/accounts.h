#pragma once

#include <deltaform/assembly/types.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  /// Works and energies since the start of the run (full circumference or per unit width); zero where energies are off.
  struct EnergyAccount
  {
    double tool_work = 0;
    double load_work = 0; ///< of other loads and of supports
    double elastic = 0, plastic = 0, friction = 0;
    double friction_error = 0; ///< expected error of the friction energy by long increments
    double climbing = 0; ///< work along the face against normal forces so far; no part of the balance
    double contact = 0; ///< stored now in the penalty springs
    double epsilon_work = 0; ///< what penalty springs gain beyond the work of their forces
    double thickness_work = 0; ///< done by what is updated between increments

    /// What was stored and dissipated.
    double taken_up() const
    {
      return elastic + plastic + friction + contact;
    }

    /// Works minus energies.
    double surplus() const
    {
      return tool_work + load_work + epsilon_work + thickness_work - taken_up();
    }

    /// The surplus over the largest of works and energies.
    double error() const
    {
      return over_largest(surplus());
    }

    /// What contact at points takes of the work where a sheet slides (negative: adds to it), over the same.
    double artificial_friction() const
    {
      return over_largest(climbing);
    }

  private:
    double over_largest(const double value) const
    {
      const double size = std::max({std::abs(tool_work), std::abs(load_work), std::abs(taken_up())});
      return size > 0 ? value / size : 0.;
    }
  };
} // namespace deltaform
