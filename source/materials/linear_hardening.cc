#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

namespace deltaform
{
  namespace
  {
    /**
     * Linear: s(e) = s0 + H e, s0 > 0 and H >= 0 stresses; unbounded. In uniaxial tension the tangent modulus is
     * E H / (E + H).
     * R. Hill, The Mathematical Theory of Plasticity, Oxford 1950, chapter II.
     */
    class LinearHardening : public Hardening
    {
    public:
      explicit LinearHardening(Section &section)
        : initial_(section.number("Initial flow stress",
                                  required(200.),
                                  Range::positive(),
                                  "stress",
                                  "Flow stress s0 at plastic strain 0.")),
          modulus_(section.number("Hardening modulus",
                                  required(300.),
                                  Range::not_negative(),
                                  "stress",
                                  "Slope H of the flow stress against the plastic strain (not the tangent modulus)."))
      {
      }

      FlowStress evaluate(const double e) const override
      {
        return {initial_ + modulus_ * e, modulus_};
      }

    private:
      double initial_, modulus_;
    };

    const Registry<Hardening>::Entry entry("linear", "s0 + H e", make_as<LinearHardening, Hardening>);
  } // namespace
} // namespace deltaform
