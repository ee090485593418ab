#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Swift: s(e) = K (e0 + e)^n, K > 0 a stress, prestrain e0 >= 0, 0 < n <= 1. Initial flow stress K e0^n; unbounded;
     * the slope at e = 0 is n K e0^(n-1), infinite for e0 = 0, n < 1.
     * H.W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1.
     */
    class Swift : public Hardening
    {
    public:
      explicit Swift(Section &section)
        : strength_(section.number("Strength coefficient",
                                   required(589.),
                                   Range::positive(),
                                   "stress",
                                   "K: flow stress at e0 + e = 1.")),
          prestrain_(section.number("Prestrain",
                                    required(1e-4),
                                    Range::not_negative(),
                                    "1",
                                    "Strain e0 that the material has seen before.")),
          exponent_(section.number("Hardening exponent", required(.216), Range::above_to(0., 1.), "1", "Exponent n."))
      {
      }

      FlowStress evaluate(const double e) const override
      {
        const double x = prestrain_ + e;
        const double value = strength_ * std::pow(x, exponent_);
        if (x > 0.)
          return {value, exponent_ * value / x};
        return {value, exponent_ < 1. ? std::numeric_limits<double>::infinity() : strength_};
      }

    private:
      double strength_, prestrain_, exponent_;
    };

    const Registry<Hardening>::Entry entry("swift", "K (e0 + e)^n", make_as<Swift, Hardening>);
  } // namespace
} // namespace deltaform
