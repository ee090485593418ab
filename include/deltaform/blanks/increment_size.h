#pragma once

namespace deltaform
{
  /// How far an increment leads.
  struct IncrementSize
  {
    double strain = 0; ///< largest change of logarithmic strain of any point
    double rotation = 0; ///< largest angle that a point turns by
  };
} // namespace deltaform
