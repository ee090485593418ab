#pragma once

#include <deltaform/increment/block_comparison.h>

namespace deltaform
{
  /**
   * Searches the number of iterations to aim at with which the process moves fastest: increments of twice the length
   * are cheaper if they take less than twice the iterations. Two neighbouring numbers are compared; the better one is
   * compared with its neighbour on the other side next.
   */
  class TargetSearch
  {
  public:
    /// What is aimed at now, where @p least is asked for.
    unsigned int target(const unsigned int least) const
    {
      return least + (comparison_.tries_other() ? other() : own_);
    }

    /// An increment of this @p length was accepted, for so many @p iterations, failed attempts included.
    void accept(double length, unsigned int iterations);

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &own_ &up_ &comparison_;
    }

  private:
    unsigned int other() const;

    unsigned int own_ = 0; ///< more than the least
    bool up_ = true; ///< the neighbour that it is compared with is the larger one
    BlockComparison<20, 6> comparison_; ///< of the own number and the neighbour
  };
} // namespace deltaform
