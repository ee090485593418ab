#include "worst.h"

#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  namespace
  {
    /// Has the blank snapped to another equilibrium, and a node turned by more than is allowed?
    class Snaps : public SavedCondition<Snaps>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        worst_.tell(increment.snap_rotation, increment.time);
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (worst_.n == 0)
          return {};
        return {"snap: in " + std::to_string(worst_.n) +
                " increments the blank snapped to another equilibrium, and nodes turned by up to " +
                text::rounded(worst_.value) + " rad (the most at time " + text::rounded(worst_.time) +
                "), more than Solver/Largest rotation increment. Look at the pictures before and after: which "
                "equilibrium the blank snaps to is not certain."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &worst_;
      }

    private:
      Worst worst_;
    };

    const ConditionMakers::Entry entry("snaps", "the blank has snapped to another equilibrium", make_condition<Snaps>);
  } // namespace
} // namespace deltaform
