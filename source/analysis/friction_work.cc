#include <deltaform/analysis/conditions.h>
#include <deltaform/base/percent.h>
#include <deltaform/model/accepted_increment.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// How well is the work of friction known at the end (doc/time_integration.md)?
    class FrictionWork : public Condition
    {
    public:
      explicit FrictionWork(const Actors &)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        const EnergyAccount &account = increment.energies();
        friction_ = account.friction;
        error_ = account.friction_error;
        work_ = std::max(account.tool_work, account.load_work);
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = .05, worth_a_word = .01;
        if (error_ <= largest * friction_ || friction_ <= worth_a_word * work_)
          return {};
        return {"friction work: it is uncertain by about " + text::percent(error_ / friction_) +
                ", because nodes begin and end to slide within increments that are long. Set a smaller Largest "
                "increment in Steps/<stage>."};
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << friction_ << error_ << work_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> friction_ >> error_ >> work_;
      }

    private:
      double friction_ = 0., error_ = 0., work_ = 0.; ///< of the last increment
    };

    const ConditionEntry entry("friction work", [](const Actors &actors) -> std::unique_ptr<Condition> {
      return std::make_unique<FrictionWork>(actors);
    });
  } // namespace
} // namespace deltaform
