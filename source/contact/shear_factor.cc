// Shear factor: |t| <= min(m k A, lambda), k = s/sqrt(3) the shear flow stress (von Mises) of the blank's surface with
// flow stress s, A the tributary area. The law of bulk forming, where the pressure is far above m k and does not
// matter. At the rim of the contact zone, where it is below, friction is the pressure: a point that carried m k A from
// the first touch on would jump when it comes, and sides that fold onto a die bring many. m = 1: the blank shears
// before it slides. (Altan, Oh, Gegel, Metal Forming, ASM 1983.)
#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    class ShearFactor : public FrictionLaw
    {
    public:
      explicit ShearFactor(Section &section)
        : factor_(section.number("Shear factor",
                                 required(.2),
                                 Range::between(0., 1.),
                                 "1",
                                 "m: share of the shear flow stress of the blank's surface that friction reaches."))
      {
      }

      FrictionLimit limit(const FrictionInput &input) const override
      {
        const double by_shear = factor_ * std::sqrt(1. / 3.) * input.flow_stress * input.area;
        // Of an elastic surface it is no law at all, and a scene is told so.
        const bool at_rim = input.normal_force <= by_shear && std::isfinite(by_shear);
        return at_rim ? FrictionLimit{input.normal_force, 1.} : FrictionLimit{by_shear, 0.};
      }

      bool acts() const override
      {
        return factor_ > 0.;
      }

      bool depends_on_pressure() const override
      {
        return true;
      }

      bool needs_flow_stress() const override
      {
        return true;
      }

    private:
      double factor_;
    };

    const Registry<FrictionLaw>::Entry entry("shear factor",
                                             "|t| <= min(m k A, lambda), k the shear flow stress of the surface",
                                             &make_as<ShearFactor, FrictionLaw>);
  } // namespace
} // namespace deltaform
