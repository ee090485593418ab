#pragma once

#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /// The unknowns of a sheet from element to element, as they follow each other along it. Empty: the blank has no such
  /// order.
  struct ElementChain
  {
    /// Of every unknown of the blank the same one an element further towards the end of the sheet, and towards its
    /// start; there itself.
    std::vector<DofIndex> ahead, behind;

    std::vector<DofIndex> rotations; ///< of the ends of the elements, from start to end of the sheet

    static const ElementChain &none()
    {
      static const ElementChain chain;
      return chain;
    }

    bool empty() const
    {
      return rotations.empty();
    }
  };
} // namespace deltaform
