#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Ludwik: s(e) = s0 + K e^n, s0 >= 0 and K >= 0 stresses, 0 < n <= 1; unbounded. The slope n K e^(n-1) is infinite
     * at e = 0 (n < 1, K > 0). P. Ludwik, Elemente der technologischen Mechanik, Springer 1909.
     */
    class Ludwik : public Hardening
    {
    public:
      explicit Ludwik(Section &section)
        : initial_(section.number("Initial flow stress",
                                  required(194.),
                                  Range::not_negative(),
                                  "stress",
                                  "Flow stress s0 at plastic strain 0.")),
          strength_(section.number("Strength coefficient",
                                   required(550.),
                                   Range::not_negative(),
                                   "stress",
                                   "K: what plastic strain 1 adds to the flow stress.")),
          exponent_(section.number("Hardening exponent", required(.223), Range::above_to(0., 1.), "1", "Exponent n."))
      {
        if (initial_ == 0. && strength_ == 0.)
          section.fail("Strength coefficient", "the flow stress would be zero at all strains.");
      }

      FlowStress evaluate(const double e) const override
      {
        if (e > 0.)
        {
          const double power = strength_ * std::pow(e, exponent_);
          return {initial_ + power, exponent_ * power / e};
        }
        const bool unbounded = exponent_ < 1. && strength_ > 0.;
        return {initial_, unbounded ? std::numeric_limits<double>::infinity() : strength_};
      }

    private:
      double initial_, strength_, exponent_;
    };

    const Registry<Hardening>::Entry entry("ludwik", "s0 + K e^n", make_as<Ludwik, Hardening>);
  } // namespace
} // namespace deltaform
