#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::multigrid, true);
    }

    const Registry<LinearMethod>::Entry
      entry("cg amg", "Conjugate gradients (no friction) with algebraic multigrid, for large solids", make);
  } // namespace
} // namespace deltaform
