#pragma once

#include <deltaform/assembly/status.h>
#include <deltaform/assembly/types.h>

#include <cstddef>

namespace deltaform
{
  /**
   * Inequalities among the equations, each active or not (contact). Newton's method on such equations is semi-smooth:
   * residuals of two sets do not compare, and a small one is a solution only if the set is consistent with it.
   */
  class ActiveSet
  {
  public:
    virtual ~ActiveSet() = default;

    /// Which inequalities will be active after the step @p d from @p q, the place of the last assembly, if everything
    /// is linear? @return is it another set than that of the last assembly? Equations::assemble_foreseen() takes it
    virtual bool foresee(const Vector & /*q*/, const Vector & /*d*/)
    {
      return false;
    }

    /// The set that foresee() has found loses more: the neighbours of those that leave it, up to @p reach places away.
    virtual void peel(unsigned int /*reach*/)
    {
    }

    /// Hash of the set of the last assembly.
    virtual std::size_t signature() const = 0;

    /// A step @p d was computed from the state that was assembled last.
    virtual void prepare_step(const Vector &d) = 0;

    /// It is taken by @p factor; the assembly at the new place follows.
    virtual void advance(double factor) = 0;

    /// Did the last assembly belong to another set than the one before?
    virtual bool changed() const = 0;

    /// For how many iterations a residual may grow with a changed set before the line search is used all the same.
    virtual unsigned int patience() const = 0;

    /// Is the assembled state admissible as a solution if its residual is small enough? Forces that can only push may
    /// pull by up to @p allowed_tension.
    virtual bool consistent(double allowed_tension) const = 0;

    /// Remember the set and what belongs to it, as they were assembled last.
    virtual void keep()
    {
    }

    /// To what was kept: what has been tried since led nowhere. The next assembly is at the place of that time.
    virtual void go_back()
    {
    }
  };


  /// A model and a state as Newton's method sees them: numbers, no physics.
  class Equations
  {
  public:
    virtual ~Equations() = default;

    /// A length of the problem (the thickness): displacements of 1 % of it are large enough to measure steps by.
    virtual double typical_length() const = 0;

    /// Residual, and tangent if wanted, at @p q into the system.
    virtual Status assemble(const Vector &q, bool tangent) = 0;

    /// Shorten components of the step @p d that nothing resists. @return the largest factor in (0, 1] of the step
    /// that is admissible from @p q
    virtual double limit_step(const Vector &q, Vector &d) const = 0;

    /**
     * After an assembly with tangent at @p q: assemble it again at the same place, for the set that
     * ActiveSet::foresee() found, or with the factors that correct_early() has changed; what the inequalities have no
     * part in stays. @return false if that saves nothing
     */
    virtual bool assemble_foreseen(const Vector & /*q*/)
    {
      return false;
    }

    /// After an assembly: what is left of the sum of all forces on the blank, over the largest of them.
    virtual double imbalance() const
    {
      return 0.;
    }

    /// The inequalities among the equations; null: there are none.
    virtual ActiveSet *active_set() = 0;

    /// Close to equilibrium, after an assembly: those corrections that need not wait for convergence. @return how many
    /// parameters were changed, so that the equations must be assembled again
    virtual unsigned int correct_early()
    {
      return 0;
    }

    /// After convergence to @p q: @return how many parameters (penalty factors, the pressure on a shell) were changed,
    /// so that the solve must go on.
    virtual unsigned int correct(const Vector &q) = 0;
  };
} // namespace deltaform
