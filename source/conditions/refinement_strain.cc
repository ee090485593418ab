#include "worst.h"

#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  namespace
  {
    /// Has a new equilibrium after a refinement strained a point by more than an increment may?
    class RefinementStrain : public SavedCondition<RefinementStrain>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        worst_.tell(increment.strain_at_rest, increment.time);
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (worst_.n == 0)
          return {};
        return {"refinement: restoring equilibrium after " + std::to_string(worst_.n) +
                " refinements strained a point by up to " + text::rounded(worst_.value) + " (the most at time " +
                text::rounded(worst_.time) +
                "), more than Solver/Largest strain increment. The mesh was too coarse when it was refined: begin with "
                "a finer one, or refine earlier (Blank/Refinement)."};
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
      entry("refinement strain", "a refinement strains the metal too far", make_condition<RefinementStrain>);
  } // namespace
} // namespace deltaform
