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


    /// Has the blank snapped to another equilibrium, and a node turned by much?
    class Snaps : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.snap.rotation;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "snap: " + snapped(worst) + "nodes turned by up to " + text::rounded(worst.value) +
               " rad at once (the most at time " + text::rounded(worst.time) +
               "). Look at the pictures before and after: which "
               "equilibrium the blank snaps to is not certain.";
      }
    };


    /// And has a point strained by much?
    class StrainOfSnaps : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.snap.strain;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "strain of a snap: " + snapped(worst) + "points strained by up to " + text::rounded(worst.value) +
               " at once (the most at time " + text::rounded(worst.time) +
               "). Their stresses are those of a straight way, and a spot may be thin that another mesh does not have.";
      }
    };

    const ConditionMakers::Entry entry("snaps", "the blank has snapped to another equilibrium", make_condition<Snaps>),
      strain("snaps, strain", "and has strained a point", make_condition<StrainOfSnaps>);
  } // namespace
} // namespace deltaform
