// Augmented Lagrangian: every increment begins with s = 0 and penetrates like a penalty, then Uzawa's iteration.
#include "augmented_lagrangian.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    const Registry<NormalLaw>::Entry entry("augmented Lagrangian",
                                           "lambda = s + eps penetration, s := lambda until the gaps vanish (Uzawa)",
                                           &make_as<AugmentedLagrangian, NormalLaw>);
  } // namespace
} // namespace deltaform
