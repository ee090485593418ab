// Active set: gap = 0 where lambda > 0. The force of every contact point is an unknown; the semi-smooth Newton method
// chooses the set by the sign of lambda - c gap with c > 0.
#include <deltaform/contact/enforcement.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    class ActiveSet : public Enforcement
    {
    public:
      explicit ActiveSet(Section &)
      {
      }

      NormalResponse respond(const ContactPointState &state, const double gap, const double multiplier) const override
      {
        NormalResponse response;
        response.tied = multiplier - weight(state) * gap >= 0;
        response.touching = response.tied;
        response.force = response.tied ? multiplier : 0.;
        return response;
      }

      bool has_multiplier() const override
      {
        return true;
      }

      bool uses_penalty() const override
      {
        return false;
      }
    };

    const Registry<Enforcement>::Entry entry("active set",
                                             "gap = 0 exactly where the reaction is compressive; no penalty factor",
                                             &make_as<ActiveSet, Enforcement>);
  } // namespace
} // namespace deltaform
