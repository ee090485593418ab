#pragma once

#include <deltaform/assembly/term.h>
#include <deltaform/stage/actors.h>
#include <deltaform/stage/contact_set.h>

#include <vector>

namespace deltaform
{
  /// The blank as a term of the equations, and its heat between them. Every process adds its own cells.
  class Body : public Term
  {
  public:
    Body(const Actors &actors, const ContactSet &contact)
      : blank_(*actors.blank), heat_(actors.heat.get()), contact_(contact)
    {
    }

    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override
    {
      blank_.add_couplings(pattern);
    }

    /// See Blank::begin_increment().
    void begin_increment(const double duration, const double ratio) const
    {
      blank_.begin_increment(duration, ratio);
    }

    Status assemble(const Vector &q, const double /*time*/, AssemblyTarget &target) const override
    {
      return blank_.assemble(q, target);
    }

    /// Contact has been accepted before.
    void accept(const Vector &q, double /*time*/, const double duration) override
    {
      blank_.commit(q);
      if (heat_ != nullptr)
        heat_->advance(duration, q, contact_.interfaces());
    }

    /// See Adaptive::refine().
    void refine(std::vector<Vector> &fields)
    {
      if (heat_ != nullptr)
        fields.push_back(heat_->rise());
      blank_.adaptive()->refine(fields);
      if (heat_ == nullptr)
        return;
      heat_->set_rise(fields.back());
      fields.pop_back();
    }

    /// @name State of blank and heat
    ///@{
    KeyedArrays state() const
    {
      KeyedArrays result = blank_.state();
      if (heat_ != nullptr)
        heat_->put(result);
      return result;
    }

    void set_state(const KeyedArrays &state)
    {
      blank_.set_state(state);
      if (heat_ != nullptr)
        heat_->take(state);
    }
    ///@}

    void add_to(EnergyAccount &account) const override
    {
      const BlankEnergy energy = blank_.energy();
      account.elastic += energy.elastic;
      account.plastic += energy.plastic;
      account.thickness_work += energy.normal;
    }

    void count_no_energy() override
    {
      blank_.count_no_energy();
    }

  private:
    Blank &blank_;
    HeatFlow *heat_; ///< null: none flows
    const ContactSet &contact_;
  };
} // namespace deltaform
