#pragma once
// What the augmented forms share: lambda = s - eps gap while positive; after each converged solve s := lambda (Uzawa;
// Hestenes 1969, Powell 1969; for contact Simo, Laursen, Comput. Struct. 42 (1992) 97), until the gaps of the loaded
// points vanish: exact contact at a factor that stays soft.
#include "spring_law.h"

#include <deltaform/parameters/section.h>

namespace deltaform
{
  class AugmentedLagrangian : public SpringLaw
  {
  public:
    explicit AugmentedLagrangian(Section &section)
      : tolerance_(section.number("Augmentation tolerance",
                                  1e-7,
                                  Range::above_to(0, 1),
                                  "1",
                                  "Augmentation ends when no loaded point has a larger |gap|, in units of the allowed "
                                  "penetration; ten times as much is allowed after every twelve rounds."))
    {
    }

    using SpringLaw::respond;
    NormalResponse respond(const ContactPointState &state, const double gap, const double multiplier) const override
    {
      // The distance from the gap at which the force is zero.
      const double effective = state.shift > 0 ? gap - state.shift / state.penalty_factor : gap;
      if (multiplier > 0 ? multiplier < weight(state) * effective : effective > 0)
        return {};
      return spring(state, gap);
    }

    double augmentation_tolerance() const override
    {
      return tolerance_;
    }

  private:
    double tolerance_;
  };
} // namespace deltaform
