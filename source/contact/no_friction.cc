// None: a smooth tool, t = 0.
#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    class NoFriction : public FrictionLaw
    {
    public:
      explicit NoFriction(Section &)
      {
      }

      FrictionLimit limit(const FrictionInput &) const override
      {
        return {};
      }

      bool acts() const override
      {
        return false;
      }
    };

    const Registry<FrictionLaw>::Entry entry("none", "t = 0: a smooth tool", &make_as<NoFriction, FrictionLaw>);
  } // namespace
} // namespace deltaform
