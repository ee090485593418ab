#pragma once

namespace deltaform
{
  /// What an accepted increment cost, attempts that failed included.
  struct IncrementCost
  {
    unsigned int iterations = 0; ///< of Newton's method
    unsigned int rounds = 0; ///< converged solves after which penalty factors were corrected
    unsigned int correction_iterations = 0; ///< of the iterations, those after the first convergence of a solve
    unsigned int linear_iterations = 0; ///< of an iterative linear solver
    unsigned int cutbacks = 0; ///< attempts that failed
    unsigned int rejected_iterations = 0; ///< of the iterations, those of attempts that failed

    IncrementCost &operator+=(const IncrementCost &other)
    {
      iterations += other.iterations;
      rounds += other.rounds;
      correction_iterations += other.correction_iterations;
      linear_iterations += other.linear_iterations;
      cutbacks += other.cutbacks;
      rejected_iterations += other.rejected_iterations;
      return *this;
    }

    /// An attempt that these iterations, already counted, belong to has failed.
    void count_failure(const unsigned int n_iterations)
    {
      ++cutbacks;
      rejected_iterations += n_iterations;
    }
  };
} // namespace deltaform
