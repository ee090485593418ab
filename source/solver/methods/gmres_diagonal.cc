#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::diagonal, false);
    }

    const Registry<LinearMethod>::Entry
      entry("gmres diagonal", "GMRES with the diagonal", make);
  } // namespace
} // namespace deltaform
