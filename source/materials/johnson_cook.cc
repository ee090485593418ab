#include "rate_law.h"

#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Johnson and Cook: s (1 + C ln(rate/rate0)), C >= 0, rate0 > 0 per time. Under rate0 the logarithm is left out:
     * the factor is 1 there, and its slope jumps at rate0. G.R. Johnson, W.H. Cook, A constitutive model and data for
     * metals subjected to large strains, high strain rates and high temperatures, Proc. 7th Int. Symp. Ballistics
     * (1983) 541.
     */
    struct JohnsonCook
    {
      double C, reference;

      RateStress operator()(const double slow, const double rate) const
      {
        if (!(rate > reference))
          return {slow, 1., 0.};
        const double factor = 1. + C * std::log(rate / reference);
        return {slow * factor, factor, slow * C / rate};
      }

      static const ParameterTable<JohnsonCook> &parameters()
      {
        static const ParameterTable<JohnsonCook> table{
          {{"Rate coefficient", &JohnsonCook::C, Range::not_negative(), "1", "C in s (1 + C ln(rate/rate0)).", .025},
           {"Reference rate", &JohnsonCook::reference, Range::positive(), "1/time",
            "rate0: below it the flow stress does not depend on the rate.", 1.}}};
        return table;
      }
    };

    const Registry<RateFactor>::Entry
      entry("johnson-cook", "s (1 + C ln(rate/rate0)), s under rate0", rate_factor_from<JohnsonCook>);
  } // namespace
} // namespace deltaform
