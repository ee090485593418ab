#include "worst.h"

#include <deltaform/parameters/text.h>

namespace deltaform
{
  namespace
  {
    std::string snapped(const Worst &worst)
    {
      return "in " + std::to_string(worst.n) + " increments the blank snapped to another equilibrium, and ";
    }


    /// Has the blank snapped to another equilibrium, and a node turned by more than is allowed?
    class Snaps : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.snap.rotation;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "snap: " + snapped(worst) + "nodes turned by up to " + text::rounded(worst.value) +
               " rad (the most at time " + text::rounded(worst.time) +
               "), more than Solver/Largest rotation increment. Look at the pictures before and after: which "
               "equilibrium the blank snaps to is not certain.";
      }
    };


    /// And has a point strained by more?
    class StrainOfSnaps : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.snap.strain;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "strain of a snap: " + snapped(worst) + "points strained by up to " + text::rounded(worst.value) +
               " (the most at time " + text::rounded(worst.time) +
               "), more than Solver/Largest strain increment. Their stresses are those of a straight way.";
      }
    };

    const ConditionMakers::Entry entry("snaps", "the blank has snapped to another equilibrium", make_condition<Snaps>),
      strain("snaps, strain", "and has strained a point by more than is allowed", make_condition<StrainOfSnaps>);
  } // namespace
} // namespace deltaform
