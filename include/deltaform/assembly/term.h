#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/status.h>
#include <deltaform/assembly/types.h>

namespace deltaform
{
  class System;

  /**
   * What adds to the equations R(q) = f_int - f_ext = 0: the body, a load, released forces, contact. A model adds up
   * the terms that take part in its stage, the body first and contact last, and accepts them in the opposite order,
   * because contact reads the thickness that the body then updates.
   */
  class Term
  {
  public:
    virtual ~Term() = default;

    /// The tangent of the body at @p q, before any other term is added. @param tangent is that of the others needed
    /// too?
    virtual void read_body(const Vector & /*q*/, const System & /*body*/, bool /*tangent*/)
    {
    }

    /// Add the residual and, if wanted, the tangent at the unknowns @p q and the end @p time of the increment.
    virtual Status assemble(const Vector &q, double time, AssemblyTarget &target) = 0;

    /// Accept the state that was assembled last, at @p q.
    virtual void accept(const Vector & /*q*/)
    {
    }

    /// All terms are accepted; the body has updated its thickness.
    virtual void refresh(const Vector & /*q*/)
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
