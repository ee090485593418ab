#pragma once

#include <deltaform/assembly/status.h>
#include <deltaform/increment/equations.h>
#include <deltaform/process/timers.h>
#include <deltaform/solver/system.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Section;
  class SetLimit;

  /// Tolerances and limits of the Newton iteration.
  struct NewtonSettings
  {
    explicit NewtonSettings(Section &section);

    unsigned int max_iterations;
    unsigned int max_rounds;
    double force_tolerance, relaxed_tolerance, balance_tolerance, displacement_tolerance;
    bool line_search;
  };

  /// What a Newton solve did.
  struct NewtonResult
  {
    enum class Outcome : unsigned char
    {
      converged,
      diverged,
      singular,
      inadmissible, ///< a status of the laws
      not_corrected ///< converged, but the corrections did not end
    };

    Outcome outcome = Outcome::diverged;
    unsigned int iterations = 0, rounds = 0, line_searches = 0;
    unsigned int correction_iterations = 0; ///< those after the first convergence: what the corrections cost
    Status status;
    unsigned int worst_dof = invalid_index; ///< largest share of the residual
    double imbalance = 0.; ///< of a solve that ended with a small residual: see Equations::imbalance()
    std::vector<double> residuals; ///< relative, of every iteration since the last correction

    bool converged() const
    {
      return outcome == Outcome::converged;
    }
  };

  /**
   * Newton's method with a line search on the work of the residual along the step, and rounds of corrections after
   * convergence. Converged: |R| <= tolerance * sum of absolute contributions, the forces on the blank in balance, and
   * the last step small against the increment; rotations are scaled by the problem's length, so that both norms have
   * one unit.
   */
  class Newton
  {
  public:
    /**
     * @param scale of every unknown: makes rotations comparable with displacements (scale * q) and moments with forces
     * (R / scale)
     * @param size  of the numbers from which the forces of an unknown are computed (coordinates, angles): its unit in
     * the last place times the stiffness is the round-off of the residual, below which nothing converges
     */
    Newton(Equations &equations, System &system, const NewtonSettings &settings, const std::vector<double> &scale,
           const std::vector<double> &size, Timers &timers);

    /**
     * @param q          in: start; out: solution
     * @param prescribed values that prescribed unknowns must reach
     * @param is_prescribed which they are
     * @param q_committed start of the increment, for the scale of the displacements
     * @param force_floor forces below this are round-off
     */
    NewtonResult solve(Vector &q, const Vector &prescribed, const std::vector<bool> &is_prescribed,
                       const Vector &q_committed, double force_floor);

    /// The same method, without StepDamping, for equations of the same unknowns that resist every step. All three have
    /// to outlive it.
    Newton for_viscous_equations(Equations &equations, const NewtonSettings &settings) const
    {
      Newton newton(equations, system_, settings, scale_, size_, timers_);
      newton.damps_ = false;
      newton.set_limit_ = set_limit_;
      return newton;
    }

    /// Searches for sets are limited by @p limit from now on, which has to outlive it.
    void limit_sets(SetLimit &limit)
    {
      set_limit_ = &limit;
    }

    /// What it solves with.
    System &system()
    {
      return system_;
    }

    const NewtonSettings &settings() const
    {
      return settings_;
    }

    /// Of every unknown.
    ///@{
    const std::vector<double> &scale() const
    {
      return scale_;
    }
    const std::vector<double> &size() const
    {
      return size_;
    }
    ///@}

  private:
    class Solve;

    Equations &equations_;
    System &system_;
    NewtonSettings settings_;
    const std::vector<double> &scale_, &size_;
    double smallest_motion_; ///< displacements below are not a scale to measure steps by
    bool damps_ = true; ///< steps that nothing resists
    SetLimit *set_limit_ = nullptr; ///< null: none but the largest
    Timers &timers_;
  };
} // namespace deltaform
