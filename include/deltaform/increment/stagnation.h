#pragma once

#include <vector>

namespace deltaform
{
  /// When the residuals of a solve no longer fall: a shorter increment is cheaper than more iterations.
  struct Stagnation
  {
    unsigned int window; ///< iterations that are compared with all before
    unsigned int long_window; ///< the same where steps say little about the residual
    unsigned int most_iterations; ///< of the solve
    double near; ///< residual below which their fall is extrapolated
    double tolerance; ///< at which less than equilibrium will do

    /**
     * Whether the relative @p residuals, the first of them at the start, lead nowhere. From @p near on: their smallest
     * one has not halved in the last iterations. Below: it would not come to the @p tolerance within the
     * most iterations, if it went on to fall as in the last ones. As long as there are no more than the window: no.
     * @param is_patient the long window counts
     */
    bool reached(const std::vector<double> &residuals, bool is_patient = false) const;
  };
} // namespace deltaform
