#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/model/term.h>

namespace deltaform
{
  /// The blank as a term of the equations. Every process adds its own cells.
  class Body : public Term
  {
  public:
    explicit Body(Blank &blank)
      : blank_(blank)
    {
    }

    Status assemble(const Vector &q, const double /*time*/, AssemblyTarget &target) override
    {
      return blank_.assemble(q, target);
    }

    void accept(const Vector &q) override
    {
      blank_.commit(q);
    }

    void add_to(EnergyAccount &account) const override
    {
      const BlankEnergy energy = blank_.energy();
      account.elastic += energy.elastic;
      account.plastic += energy.plastic;
      account.thickness_work += energy.normal;
    }

    void forget_energy() override
    {
      blank_.forget_energy();
    }

  private:
    Blank &blank_;
  };
} // namespace deltaform
