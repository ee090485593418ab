#include "../direct_solver.h"

#include <deltaform/parameters/registry.h>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<LinearMethod> make(Section &)
    {
      return std::make_unique<DirectMethod>("Klu");
    }

    const Registry<LinearMethod>::Entry
      entry("klu", "Direct, for thin strips", make);
  } // namespace
} // namespace deltaform
