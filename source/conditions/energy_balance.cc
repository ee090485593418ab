#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/reports/accepted_increment.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Do works and energies agree at the end?
    class EnergyBalance : public SavedCondition<EnergyBalance>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        error_ = increment.energies().error();
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = .01;
        if (std::abs(error_) <= largest)
          return {};
        return {"energy balance: works and energies differ by " + text::percent(std::abs(error_)) +
                " at the end. Set a smaller Largest increment in Steps/<stage>."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &error_;
      }

    private:
      double error_ = 0.; ///< of the last increment
    };

    const ConditionMakers::Entry
      entry("energy balance", "works and energies differ at the end", make_condition<EnergyBalance>);
  } // namespace
} // namespace deltaform
