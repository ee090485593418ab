#include "../direct_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<DirectMethod>("Mumps");
    }

    const Registry<LinearMethod>::Entry
      entry("mumps", "Direct, for blocks", make);
  } // namespace
} // namespace deltaform
