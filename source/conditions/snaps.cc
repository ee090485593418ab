#include "worst.h"

#include <deltaform/parameters/text.h>

namespace deltaform
{
  namespace
  {
    /// Has the blank snapped to another equilibrium, and a node turned by more than is allowed?
    class Snaps : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.snap_rotation;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "snap: in " + std::to_string(worst.n) +
               " increments the blank snapped to another equilibrium, and nodes turned by up to " +
               text::rounded(worst.value) + " rad (the most at time " + text::rounded(worst.time) +
               "), more than Solver/Largest rotation increment. Look at the pictures before and after: which "
               "equilibrium the blank snaps to is not certain.";
      }
    };

    const ConditionMakers::Entry entry("snaps", "the blank has snapped to another equilibrium", make_condition<Snaps>);
  } // namespace
} // namespace deltaform
