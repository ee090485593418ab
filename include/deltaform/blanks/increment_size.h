#pragma once

#include <deltaform/assembly/types.h>

namespace deltaform
{
  /// The largest changes in an increment, by which its length is judged.
  struct IncrementSize
  {
    double strain = 0; ///< largest change of logarithmic strain of any point
    double rotation = 0; ///< largest angle that a point turns by
    Point2 strained{}, turned{}; ///< where these points are in the undeformed blank
  };
} // namespace deltaform
