#pragma once

#include <deltaform/increment/newton.h>
#include <deltaform/increment/radius_search.h>
#include <deltaform/increment/set_search.h>
#include <deltaform/increment/step_damping.h>

#include <vector>

namespace deltaform
{
  /**
   * The step of an iteration of Newton's method: of the linear equations, for the set of active inequalities that it
   * leads to (SetSearch), within the radius of StepDamping (RadiusSearch). Where two sets lead to each other the radius
   * shrinks until one leads to itself: with enough damping the tangent is positive definite, and there is just one.
   * Derivation: doc/theory/solver.md.
   */
  class StepSearch
  {
  public:
    /**
     * @param scale  of every unknown, in which lengths are measured
     * @param damps  is there a radius at all?
     * @param timers where factorizations and solves are counted
     * @param limit  of the sets of a search; null: SetLimit::many
     *
     * All but @p damps has to outlive it.
     */
    StepSearch(Equations &equations, System &system, const NewtonSettings &settings, const std::vector<double> &scale,
               const std::vector<bool> &is_prescribed, Timers &timers, bool damps, SetLimit *limit);

    /// Where a step begins, as assembled last.
    struct Start
    {
      const Vector &q;
      double residual; ///< relative
      double magnitude; ///< of the forces
      bool is_moving; ///< prescribed unknowns still have to go
      bool is_first; ///< of the first iterations of an increment, whose set is looked for at any residual
    };

    /**
     * A step for the set that it leads to, where it is time to look for that.
     * @param increments of prescribed unknowns
     * @return false if there is none
     */
    bool find(const Start &start, const Vector &increments);

    /// From the start of the last step, assembled again: another one, as the radius is another one.
    bool find_again(const Start &start);

    /// The same, for the set at its start.
    bool find_without_set(const Start &start);

    /// Is there a radius?
    bool is_bound(const Start &start) const;

    /// The laws may shorten it.
    Vector &step()
    {
      return d_;
    }

    /// Of the step, scaled.
    double length() const;

    /// Is it damped? Then it is no measure of the error.
    bool is_damped() const
    {
      return radius_search_.stiffness() > 0.;
    }

    /// Has the search for its set come to no end?
    bool is_guess() const
    {
      return searched_ && sets_.is_guess();
    }

    /// Bad if there was no step as the laws could not be evaluated.
    const Status &status() const
    {
      return status_;
    }

    StepDamping &damping()
    {
      return damping_;
    }

  private:
    double radius(const Start &start) const;
    bool assemble(const Start &start);
    bool solve(double shift);

    /// A step within the radius, for one set.
    /// @param is_other_set than that of the last assembly
    bool find_direction(const Start &start, bool is_other_set);

    /// @param finds_set the set that it leads to is looked for
    bool find_within_radius(const Start &start, bool finds_set, bool is_other_set);

    Equations &equations_;
    System &system_;
    const std::vector<double> &scale_;
    Timers &timers_;
    Timers::Index timer_solve_;
    bool has_sets_, damps_;
    Vector increments_, d_; ///< of prescribed unknowns; the step
    SetSearch sets_;
    StepDamping damping_;
    RadiusSearch radius_search_;
    Status status_;
    bool searched_ = false; ///< for a set
  };
} // namespace deltaform
