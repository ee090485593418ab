#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Hockett and Sherby: s(e) = ss - (ss - s0) exp(-m e^n), 0 <= s0 <= ss stresses, m > 0, 0 < n <= 1. Goes to ss; the
     * slope at e = 0 is infinite for n < 1, m (ss - s0) for n = 1 (Voce's law).
     * J.E. Hockett, O.D. Sherby, Large strain deformation of polycrystalline metals at low homologous temperatures, J.
     * Mech. Phys. Solids 23 (1975) 87.
     */
    class HockettSherby : public Hardening
    {
    public:
      explicit HockettSherby(Section &section)
        : initial_(section.number("Initial flow stress",
                                  required(120.),
                                  Range::not_negative(),
                                  "stress",
                                  "Flow stress s0 at plastic strain 0.")),
          rise_(section.number("Saturation stress",
                               required(380.),
                               Range::positive(),
                               "stress",
                               "ss: the limit at large strain.") -
                initial_),
          rate_(section.number("Saturation rate", required(5.), Range::positive(), "1", "Rate m.")),
          exponent_(section.number("Hardening exponent", required(.75), Range::above_to(0., 1.), "1", "Exponent n."))
      {
        if (rise_ < 0.)
          section.fail("Saturation stress", "must not be less than the initial flow stress.");
      }

      FlowStress evaluate(const double e) const override
      {
        if (e > 0.)
        {
          const double power = rate_ * std::pow(e, exponent_);
          const double risen = -std::expm1(-power);
          return {initial_ + rise_ * risen, rise_ * (1. - risen) * exponent_ * power / e};
        }
        const bool unbounded = exponent_ < 1. && rise_ > 0.;
        return {initial_, unbounded ? std::numeric_limits<double>::infinity() : rise_ * rate_};
      }

    private:
      double initial_, rise_, rate_, exponent_;
    };

    const Registry<Hardening>::Entry
      entry("hockett-sherby", "ss - (ss - s0) exp(-m e^n)", make_as<HockettSherby, Hardening>);
  } // namespace
} // namespace deltaform
