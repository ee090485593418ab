#include "rate_law.h"

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Cowper and Symonds: s (1 + (rate/D)^(1/p)), D > 0 per time, p >= 1. At rate 0 the slope is infinite (p > 1),
     * which the return maps take as it is: nothing is rounded off. G.R. Cowper, P.S. Symonds, Strain-hardening and
     * strain-rate effects in the impact loading of cantilever beams, Brown University report 28 (1957).
     */
    struct CowperSymonds
    {
      double D, p;

      RateStress operator()(const double slow, const double rate) const
      {
        if (!(rate > 0.))
          return {slow, 1., p > 1. ? std::numeric_limits<double>::infinity() : slow / D};
        const double power = std::pow(rate / D, 1. / p);
        return {slow * (1. + power), 1. + power, slow * power / (p * rate)};
      }

      static const ParameterTable<CowperSymonds> &parameters()
      {
        static const ParameterTable<CowperSymonds> table{
          {{"Reference rate", &CowperSymonds::D, Range::positive(), "1/time",
            "D: the rate at which the flow stress is twice the slow one.", 40.4},
           {"Rate exponent", &CowperSymonds::p, {1.}, "1", "p, at least 1.", 5.}}};
        return table;
      }
    };

    const Registry<RateFactor>::Entry
      entry("cowper-symonds", "s (1 + (rate/D)^(1/p))", rate_factor_from<CowperSymonds>);
  } // namespace
} // namespace deltaform
