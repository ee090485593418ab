#include "worst.h"

#include <deltaform/parameters/text.h>

namespace deltaform
{
  namespace
  {
    /// Has a new equilibrium after a refinement strained a point by more than an increment may?
    class RefinementStrain : public WorstCondition
    {
      double value(const AcceptedIncrement &increment) const override
      {
        return increment.strain_at_rest;
      }

      std::string sentence(const Worst &worst) const override
      {
        return "refinement: restoring equilibrium after " + std::to_string(worst.n) +
               " refinements strained a point by up to " + text::rounded(worst.value) + " (the most at time " +
               text::rounded(worst.time) +
               "), more than Solver/Largest strain increment. The mesh was too coarse when it was refined: begin with "
               "a finer one, or refine earlier (Blank/Refinement).";
      }
    };

    const ConditionMakers::Entry
      entry("refinement strain", "a refinement strains the metal too far", make_condition<RefinementStrain>);
  } // namespace
} // namespace deltaform
