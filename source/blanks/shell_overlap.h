#pragma once

#include "shell_space.h"
#include "shell_state.h"
#include "shell_surface.h"

#include <deltaform/blanks/fields.h>

namespace deltaform
{
  /**
   * Where a shell lies within itself: two parts of it that are turned against each other by more than 150 degrees, as
   * those of a hem, and whose mid-surfaces are closer than the mean of their thicknesses. Nothing keeps them apart:
   * contact is between blank and tools.
   */
  Overlap find_overlap(const ShellSpace &space, const ShellSurface &surface, const ShellState &state, const Vector &q);
} // namespace deltaform
