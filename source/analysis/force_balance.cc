#include "worst.h"

#include <deltaform/analysis/conditions.h>
#include <deltaform/model/accepted_increment.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>

namespace deltaform
{
  namespace
  {
    /// Do the forces of tools, supports and loads balance in every increment?
    class ForceBalance : public SavedCondition<ForceBalance>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        worst_.tell(increment.balance_error(), increment.time);
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = 1e-3;
        if (worst_.value <= largest)
          return {};
        return {"force balance: the forces of tools, supports and loads leave " + text::percent(worst_.value) +
                " of the largest of them unbalanced at time " + text::rounded(worst_.time) +
                ". Set smaller Solver/Force tolerance and Relaxed force tolerance."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &worst_;
      }

    private:
      Worst worst_;
    };

    const ConditionMakers::Entry
      entry("force balance", "forces of tools, supports and loads do not balance", make_condition<ForceBalance>);
  } // namespace
} // namespace deltaform
