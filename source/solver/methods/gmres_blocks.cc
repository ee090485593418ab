#include "../iterative_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<IterativeMethod>(Preconditioner::blocks, false);
    }

    const Registry<LinearMethod>::Entry
      entry("gmres blocks", "GMRES with the blocks of one node each", make);
  } // namespace
} // namespace deltaform
