#pragma once

#include <array>
#include <optional>

namespace deltaform
{
  /**
   * Which of two ways moves a process faster, by the effort per length over blocks of increments in the order own,
   * other, other, own: so a process that gets harder favours neither. The first increments of a block still have the
   * lengths of the one before and do not count.
   */
  template <unsigned int increments_of_block, unsigned int that_do_not_count>
  class BlockComparison
  {
  public:
    bool tries_other() const
    {
      return block_ == 1 || block_ == 2;
    }

    /// An increment of this @p length was accepted, with this @p effort. @return after the last block, which the next
    /// comparison follows: is the other way faster?
    std::optional<bool> accept(const double length, const double effort)
    {
      constexpr unsigned int blocks = 4;
      if (count_ >= that_do_not_count)
      {
        Cost &cost = costs_[tries_other() ? 1 : 0];
        cost.effort += effort;
        cost.length += length;
      }
      if (++count_ < increments_of_block)
        return std::nullopt;
      count_ = 0;
      if (++block_ < blocks)
        return std::nullopt;
      const auto [own, other] = costs_;
      *this = BlockComparison();
      return other.effort * own.length < own.effort * other.length;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &block_ &count_;
      for (auto &cost : costs_)
        archive &cost.effort &cost.length;
    }

  private:
    struct Cost
    {
      double effort = 0., length = 0.;
    };

    unsigned int block_ = 0, count_ = 0; ///< increments of this block
    std::array<Cost, 2> costs_; ///< of the own way, of the other one
  };
} // namespace deltaform
