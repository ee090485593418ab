#pragma once

namespace deltaform
{
  /// Where a contact point of a refined blank lies among the old ones of its side: between two of them, @p share of the
  /// way from the first to the second. Twice the same: it is that one, or nothing lies beyond it.
  struct PointOrigin
  {
    unsigned int first, second;
    double share;
  };
} // namespace deltaform
