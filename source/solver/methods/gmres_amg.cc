#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::multigrid, false);
    }

    const Registry<LinearMethod>::Entry
      entry("gmres amg", "GMRES with algebraic multigrid, for large solids", make);
  } // namespace
} // namespace deltaform
