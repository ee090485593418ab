#pragma once

#include <array>

namespace deltaform
{
  /**
   * Searches the number of iterations to aim at with which the process moves fastest: increments of twice the length
   * are cheaper if they take less than twice the iterations. Two neighbouring numbers are compared over blocks of
   * increments in the order own, other, other, own, so that a process that gets harder favours neither; the first ones
   * of a block still have the lengths of the one before and do not count. The better number is compared with its
   * neighbour on the other side next.
   */
  class TargetSearch
  {
  public:
    /// What is aimed at now, where @p least is asked for.
    unsigned int target(const unsigned int least) const
    {
      return least + (tries_other() ? other() : own_);
    }

    /// An increment of this @p length was accepted, for so many @p iterations, failed attempts included.
    void accept(double length, unsigned int iterations);

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &own_ &up_ &block_ &count_;
      for (auto &cost : costs_)
        archive &cost.iterations &cost.length;
    }

  private:
    bool tries_other() const
    {
      return block_ == 1 || block_ == 2;
    }

    unsigned int other() const;

    struct Cost
    {
      double iterations = 0., length = 0.;
    };

    unsigned int own_ = 0; ///< more than the least
    bool up_ = true; ///< the neighbour that it is compared with is the larger one
    unsigned int block_ = 0, count_ = 0; ///< of a comparison; increments of this block
    std::array<Cost, 2> costs_; ///< of the own number, of the other one
  };
} // namespace deltaform
