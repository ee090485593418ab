#pragma once

#include <string>

namespace deltaform
{
  /**
   * Whether numbers with units can be computed with: products of a few of them must be neither infinite nor zero, and
   * lengths that are too different cannot be told apart. A size (thickness, radius) is positive; a coordinate may be
   * anything, zero and its round-off included.
   */
  class Magnitudes
  {
  public:
    /// Remember a number that was entered as @p entry in @p unit.
    /// @throws std::invalid_argument with a sentence if it does not go with those before
    void add(double value, bool is_size, const std::string &unit, const std::string &entry);

  private:
    struct Length
    {
      double value;
      std::string entry;
    };

    Length largest_{0., ""}; ///< of all lengths
    Length smallest_{0., ""}; ///< of all sizes; 0: none yet
  };
} // namespace deltaform
