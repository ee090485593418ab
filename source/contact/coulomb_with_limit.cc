// Coulomb with limit: |t| <= min(mu lambda, m k A), k = s/sqrt(3) the shear flow stress (von Mises) of the blank's
// surface with flow stress s, A the tributary area. Coulomb where the pressure is low, the shear factor where mu times
// the pressure would exceed what the blank can carry (Orowan, Proc. Inst. Mech. Eng. 150 (1943) 140).
#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    class CoulombWithLimit : public FrictionLaw
    {
    public:
      explicit CoulombWithLimit(Section &section)
        : coefficient_(section.number("Friction coefficient",
                                      required(.1),
                                      Range::not_negative(),
                                      "1",
                                      "Coulomb's coefficient mu between this tool and the blank; 0 is smooth.")),
          factor_(section.number("Shear factor",
                                 1.,
                                 Range::above_to(0., 1.),
                                 "1",
                                 "m: share of the shear flow stress of the blank's surface above which friction does "
                                 "not grow with the pressure."))
      {
      }

      FrictionLimit limit(const FrictionInput &input) const override
      {
        const double by_pressure = coefficient_ * input.normal_force;
        const double by_shear = factor_ * std::sqrt(1. / 3.) * input.flow_stress * input.area;
        return by_pressure <= by_shear ? FrictionLimit{by_pressure, coefficient_} : FrictionLimit{by_shear, 0.};
      }

      bool acts() const override
      {
        return coefficient_ > 0.;
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
      double coefficient_, factor_;
    };

    const Registry<FrictionLaw>::Entry entry("coulomb with limit",
                                             "|t| <= min(mu lambda, m k A), k the shear flow stress of the surface",
                                             &make_as<CoulombWithLimit, FrictionLaw>);
  } // namespace
} // namespace deltaform
