#include <deltaform/analysis/conditions.h>
#include <deltaform/base/percent.h>
#include <deltaform/base/text.h>
#include <deltaform/model/accepted_increment.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

namespace deltaform
{
  namespace
  {
    /// Do the forces of tools, supports and loads balance in every increment?
    class ForceBalance : public Condition
    {
    public:
      explicit ForceBalance(const Actors &)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        if (increment.balance_error() <= worst_)
          return;
        worst_ = increment.balance_error();
        time_ = increment.time;
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = 1e-3;
        if (worst_ <= largest)
          return {};
        return {"force balance: the forces of tools, supports and loads leave " + text::percent(worst_) +
                " of the largest of them unbalanced at time " + text::rounded(time_) +
                ". Set smaller Solver/Force tolerance and Relaxed force tolerance."};
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << worst_ << time_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> worst_ >> time_;
      }

    private:
      double worst_ = 0., time_ = 0.;
    };

    const ConditionEntry entry("force balance", [](const Actors &actors) -> std::unique_ptr<Condition> {
      return std::make_unique<ForceBalance>(actors);
    });
  } // namespace
} // namespace deltaform
