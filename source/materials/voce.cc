#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Voce, with a linear term: s(e) = s0 + (ss - s0) (1 - exp(-b e)) + H e, 0 <= s0 <= ss and H >= 0 stresses, b > 0.
     * Goes to ss + H e; initial slope b (ss - s0) + H.
     * E. Voce, The relationship between stress and strain for homogeneous deformation, J. Inst. Metals 74 (1948) 537.
     */
    class Voce : public Hardening
    {
    public:
      explicit Voce(Section &section)
        : initial_(section.number("Initial flow stress",
                                  required(450.),
                                  Range::not_negative(),
                                  "stress",
                                  "Flow stress s0 at plastic strain 0.")),
          rise_(section.number("Saturation stress",
                               required(715.),
                               Range::positive(),
                               "stress",
                               "ss: the limit at large strain.") -
                initial_),
          rate_(section.number("Saturation rate", required(16.93), Range::positive(), "1", "Rate b.")),
          modulus_(section.number("Linear modulus",
                                  0.,
                                  Range::not_negative(),
                                  "stress",
                                  "Slope H of the linear term, 0: none."))
      {
        if (rise_ < 0.)
          section.fail("Saturation stress", "must not be less than the initial flow stress.");
      }

      FlowStress evaluate(const double e) const override
      {
        const double risen = -std::expm1(-rate_ * e);
        return {initial_ + rise_ * risen + modulus_ * e, rise_ * rate_ * (1. - risen) + modulus_};
      }

    private:
      double initial_, rise_, rate_, modulus_;
    };

    const Registry<Hardening>::Entry entry("voce", "s0 + (ss - s0) (1 - exp(-b e)) + H e", make_as<Voce, Hardening>);
  } // namespace
} // namespace deltaform
