#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::blocks, true);
    }

    const Registry<LinearMethod>::Entry
      entry("cg blocks", "Conjugate gradients (no friction) with the blocks of one node each", make);
  } // namespace
} // namespace deltaform
