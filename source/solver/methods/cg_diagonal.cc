#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::diagonal, true);
    }

    const Registry<LinearMethod>::Entry
      entry("cg diagonal", "Conjugate gradients (no friction) with the diagonal", make);
  } // namespace
} // namespace deltaform
