// Coulomb: |t| <= mu lambda, slip only at the limit, against the motion. Return mapping of the trial t_n + eps_t ds
// (Giannakopoulos 1989); units: forces.
#include <deltaform/base/registry.h>
#include <deltaform/contact/friction_law.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    class Coulomb : public FrictionLaw
    {
    public:
      explicit Coulomb(Section &section)
        : coefficient_(section.number("Friction coefficient",
                                      0.,
                                      Range::not_negative(),
                                      "1",
                                      "Coulomb's coefficient of friction between this tool and the blank."))
      {
      }

      FrictionResponse update(const double normal_force,
                              const double committed,
                              const double slip_increment,
                              const double stiffness) const override
      {
        const double trial = committed + stiffness * slip_increment;
        const double bound = limit(normal_force);
        if (std::abs(trial) <= bound)
          return {trial, stiffness, 0., true};
        const double sign = trial > 0 ? 1. : -1.;
        return {sign * bound, 0., sign * coefficient_, false};
      }

      double limit(const double normal_force) const override
      {
        return coefficient_ * normal_force;
      }

    private:
      double coefficient_;
    };

    const Registry<FrictionLaw>::Entry entry("coulomb", "|t| <= mu lambda", &make_as<Coulomb, FrictionLaw>);
  } // namespace
} // namespace deltaform
