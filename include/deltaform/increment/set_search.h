#pragma once

#include <deltaform/increment/newton.h>
#include <deltaform/increment/set_limit.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace deltaform
{
  /**
   * Looks, before a step is made, for the set of active inequalities that the step leads to, until a set leads to
   * itself: with the tangent of the blank, which changes little close to equilibrium. Else a zone of contact grows or
   * shrinks by a point in an iteration (doc/theory/solver.md).
   */
  class SetSearch
  {
  public:
    /// Solve the equations as they were assembled last for the step, with a shift of the diagonal. @return could it?
    using Solve = std::function<bool(double shift)>;

    /// All but the settings, which are copied, has to outlive it. @param limit of the sets of a search; null: many
    SetSearch(Equations &equations,
              System &system,
              const NewtonSettings &settings,
              const std::vector<double> &scale,
              const std::vector<bool> &is_prescribed,
              SetLimit *limit);

    /// Of the last assembly: the residual, relative to the magnitude, and what StepDamping adds to the tangent there.
    struct Place
    {
      double residual, magnitude, damping;
    };

    /**
     * @param q         place of the last assembly
     * @param d         the step from there, which @p solve renews
     * @param place     what is known of q
     * @param solve     how
     * @return false if there is no step for a set that was met
     */
    bool run(const Vector &q, const Vector &d, const Place &place, const Solve &solve);

    /// Has the last search come to no end? The step is then that of a guess.
    bool is_guess() const
    {
      return is_guess_;
    }

    /// Has it ended with two sets that lead to each other?
    bool lead_to_each_other() const
    {
      return lead_to_each_other_;
    }

    /// The longer one of the last two steps that were solved for, scaled.
    double longer_step() const
    {
      return std::max(length_, length_before_);
    }

  private:
    /// Does the step solve the equations as they were assembled last, well enough for an iteration?
    bool solves_linear_equations(const Vector &d, const Place &place);

    /// run(), with the number of sets that were met.
    bool meet_sets(const Vector &q, const Vector &d, const Place &place, const Solve &solve,
                   std::vector<std::size_t> &sets);

    Equations &equations_;
    System &system_;
    double force_tolerance_;
    const std::vector<double> &scale_;
    const std::vector<bool> &is_prescribed_;
    SetLimit *limit_;
    Vector linear_; ///< R + K d
    bool is_guess_ = false, lead_to_each_other_ = false;
    double length_ = 0., length_before_ = 0.; ///< of the last two steps, scaled
  };
} // namespace deltaform
