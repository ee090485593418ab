#pragma once

#include <deltaform/assembly/types.h>

#include <deque>
#include <vector>

namespace deltaform
{
  /**
   * The balanced states that a solve has come to and left again, because its last step was not yet small. Where metal
   * yields and unloads, or points touch and let go, the step from such a state may lead away and, some iterations
   * later, back to it: so it would go on for ever. A balanced state that the solve has come back to is its solution.
   * Derivation: doc/theory/solver.md, "Convergence".
   */
  class Returns
  {
  public:
    /// The iteration is at unknowns that are not balanced. @return is that the end? No.
    bool leave()
    {
      away_ = true;
      return false;
    }

    /// It is at balanced ones, @p q. @return was it there before, to @p tolerance (scaled by @p scale), and away since?
    bool come(const Vector &q, const std::vector<double> &scale, double tolerance);

  private:
    std::deque<Vector> states_; ///< the last ones
    bool away_ = false; ///< since the last of them
  };
} // namespace deltaform
