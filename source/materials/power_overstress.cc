#include "rate_law.h"

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Overstress by a power law: s + K rate^(1/n), that is rate = ((q - s)/K)^n, K > 0 a stress at a rate of one per
     * unit of time, n >= 1. With a flow stress of zero it is the creep of Norton. At rate 0 the slope is infinite (n >
     * 1), which the return maps take as it is. P. Perzyna, Fundamental problems in viscoplasticity, Adv. Appl. Mech. 9
     * (1966) 243.
     */
    struct PowerOverstress
    {
      double K, n;

      RateStress operator()(const double slow, const double rate) const
      {
        if (!(rate > 0.))
          return {slow, 1., n > 1. ? std::numeric_limits<double>::infinity() : K};
        const double overstress = K * std::pow(rate, 1. / n);
        return {slow + overstress, 1., overstress / (n * rate)};
      }

      static const ParameterTable<PowerOverstress> &parameters()
      {
        static const ParameterTable<PowerOverstress> table{
          {{"Overstress", &PowerOverstress::K, Range::positive(), "stress",
            "K: added flow stress at a rate of 1 per unit of time.", 100.},
           {"Rate exponent", &PowerOverstress::n, {1.}, "1", "n, at least 1: rate = (overstress/K)^n.", 5.}}};
        return table;
      }
    };

    const Registry<RateFactor>::Entry entry("power", "s + K rate^(1/n)", rate_factor_from<PowerOverstress>);
  } // namespace
} // namespace deltaform
