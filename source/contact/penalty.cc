// Penalty: lambda = eps p, p = max(0, -gap)                                      (Bednarek, Kowalczyk, eqn (3))
#include <deltaform/contact/enforcement.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    class Penalty : public Enforcement
    {
    public:
      explicit Penalty(Section &)
      {
      }

      NormalResponse respond(const ContactPointState &state, const double gap, const double multiplier) const override
      {
        // gap = 0 counts as touching: a blank that just rests on a tool is held by it.
        if (multiplier > 0 ? multiplier < weight(state) * gap : gap > 0)
          return {};
        return {true, -state.penalty_factor * gap, -state.penalty_factor, false};
      }

      bool has_multiplier() const override
      {
        return false;
      }

      bool uses_penalty() const override
      {
        return true;
      }
    };

    const Registry<Enforcement>::Entry
      entry("penalty", "lambda = eps p with eps from the penalty rule", &make_as<Penalty, Enforcement>);
  } // namespace
} // namespace deltaform
