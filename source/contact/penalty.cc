// Penalty: lambda = eps penetration, penetration = max(0, -gap)                  (Bednarek, Kowalczyk, eqn (3))
#include "spring_law.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    class Penalty : public SpringLaw
    {
    public:
      explicit Penalty(Section &)
      {
      }

      using SpringLaw::respond;
      NormalResponse respond(const ContactPointState &state, const double gap, const double multiplier) const override
      {
        // gap = 0 counts as touching: a blank that just rests on a tool is held by it.
        if (multiplier > 0 ? multiplier < weight(state) * gap : gap > 0)
          return {};
        return spring(state, gap);
      }
    };

    const Registry<NormalLaw>::Entry
      entry("penalty", "lambda = eps penetration, with eps from the penalty rule", &make_as<Penalty, NormalLaw>);
  } // namespace
} // namespace deltaform
