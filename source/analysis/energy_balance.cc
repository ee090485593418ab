#include <deltaform/analysis/conditions.h>
#include <deltaform/base/percent.h>
#include <deltaform/model/accepted_increment.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Do works and energies agree at the end?
    class EnergyBalance : public Condition
    {
    public:
      explicit EnergyBalance(const Actors &)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        error_ = increment.energies().error();
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = .02;
        if (std::abs(error_) <= largest)
          return {};
        return {"energy balance: works and energies differ by " + text::percent(std::abs(error_)) +
                " at the end. Set a smaller Largest increment in Steps/<stage>."};
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << error_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> error_;
      }

    private:
      double error_ = 0.; ///< of the last increment
    };

    const ConditionEntry entry("energy balance", [](const Actors &actors) -> std::unique_ptr<Condition> {
      return std::make_unique<EnergyBalance>(actors);
    });
  } // namespace
} // namespace deltaform
