// Adaptive compensated: the augmented Lagrangian with a shifted start. With eps = lambda_n / delta of the last
// increment's force lambda_n a point would penetrate by delta; so the surface is moved against it by delta, s = eps
// delta (= lambda_n; never more, where the floor has raised eps). The true penetration is near zero from the start;
// further augmentations are those of Uzawa.
#include "augmented_lagrangian.h"

#include <deltaform/parameters/registry.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class AdaptiveCompensated : public AugmentedLagrangian
    {
    public:
      using AugmentedLagrangian::AugmentedLagrangian;

      double start_shift(const ContactPointState &state) const override
      {
        return std::min(std::max(state.force, 0.), state.penalty_factor * state.delta);
      }
    };

    const Registry<NormalLaw>::Entry
      entry("adaptive compensated",
            "augmented Lagrangian that starts shifted by delta: near zero penetration from the start",
            &make_as<AdaptiveCompensated, NormalLaw>);
  } // namespace
} // namespace deltaform
