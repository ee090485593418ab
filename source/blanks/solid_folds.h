#pragma once

#include "solid_space.h"

#include <deltaform/blanks/fields.h>

namespace deltaform
{
  /**
   * Cells of a solid where metal is turned inside out at a corner: det dx/dX <= 0 there, though it is positive at the
   * points of integration, which alone the equations know. All processes together.
   * @param q of all nodes, also of hanging ones
   */
  FoldedCells find_folded_cells(const SolidSpace &space, const Vector &q);
} // namespace deltaform
