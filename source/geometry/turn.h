#pragma once
// How lines and arcs turn, and what of them is round-off.
#include <deltaform/assembly/types.h>

namespace deltaform
{
  /// Corners and arcs that turn by less (rad) are straight.
  constexpr double smallest_turn = 1e-9;

  /// Lines that are shorter than this part of their edge are none; a closest point may lie past the end of a line by
  /// this part of it.
  constexpr double length_tolerance = 1e-12;

  /// Positive if @p b is to the left of @p a: the product of their lengths and the sine of the angle between.
  inline double cross(const Tensor1 &a, const Tensor1 &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }
} // namespace deltaform
