#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/status.h>
#include <deltaform/assembly/types.h>

namespace dealii
{
  class DynamicSparsityPattern;
}

namespace deltaform
{
  /**
   * What adds to the equations R(q) = f_int - f_ext = 0: the body, a load, released forces, contact. A model adds up
   * the terms that take part in its stage, the body first and contact last, and accepts them in the opposite order,
   * because contact reads the thickness that the body then updates.
   *
   * Body and contact are evaluated and added in one sweep, cell by cell and point by point: kept apart, the tangents of
   * all cells would have to be stored, as much memory again as the matrix takes.
   */
  class Term
  {
  public:
    virtual ~Term() = default;

    /// Enter the couplings between unknowns that it makes in any stage: the matrix has places for these entries of the
    /// tangent and no others. The blank enters those of the cells of this process, others all of theirs.
    virtual void add_couplings(dealii::DynamicSparsityPattern & /*pattern*/) const
    {
    }

    /// Add the residual and, if wanted, the tangent at the unknowns @p q and the end @p time of the increment. The term
    /// itself stays as it is; the trial state of blank and contact points, which it reads and writes, is theirs.
    virtual Status assemble(const Vector &q, double time, AssemblyTarget &target) const = 0;

    /// Accept the state that was assembled last, at @p q, at the end @p time of an increment that took @p duration.
    virtual void accept(const Vector & /*q*/, double /*time*/, double /*duration*/)
    {
    }

    /// Add the energies of the accepted state, and the work done by what changes between increments.
    virtual void add_to(EnergyAccount & /*account*/) const
    {
    }

    /// Switch energies off: they are zero from here on, and cost nothing.
    virtual void count_no_energy()
    {
    }
  };
} // namespace deltaform
