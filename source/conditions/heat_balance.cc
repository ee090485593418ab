#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Is the heat of the blank that which was made and exchanged? Only round-off makes a difference, where conduction
    /// moves very much more heat to and fro than the blank holds.
    class HeatBalance : public Condition
    {
    public:
      explicit HeatBalance(const Actors &actors)
        : heat_(actors.heat.get())
      {
      }

      void observe(const AcceptedIncrement &) override
      {
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = 1e-6;
        const double error = heat_ != nullptr ? std::abs(heat_->account().error()) : 0.;
        if (error <= largest)
          return {};
        return {"heat balance: what was made and exchanged differs by " + text::rounded(error) +
                " from what is stored (heat_error). Look at the units of Conductivity, Conductance and Film "
                "coefficient, and at the length of the increments."};
      }

      void save(boost::archive::binary_oarchive &) const override
      {
      }

      void load(boost::archive::binary_iarchive &) override
      {
      }

    private:
      const HeatFlow *heat_; ///< null: none flows
    };

    const ConditionMakers::Entry
      entry("heat balance", "heat is lost or gained by round-off", make_condition<HeatBalance>);
  } // namespace
} // namespace deltaform
