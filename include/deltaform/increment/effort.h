#pragma once

namespace deltaform
{
  /// How much may be tried to find an equilibrium, from little to all.
  enum class Effort : unsigned char
  {
    first, ///< of an increment that continues others: if it fails, a shorter one is cheaper than another strategy
    usual, ///< a shorter increment did not help, or there is nothing to continue
    last_resorts, ///< shorter increments did not help
    all ///< the shortest increment: where the blank snaps through, rotations may be large
  };
} // namespace deltaform
