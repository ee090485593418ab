#include <deltaform/increment/target_search.h>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int most = 3; // more than the least
    constexpr unsigned int increments_of_block = 20, that_do_not_count = 6, blocks = 4;
  } // namespace


  unsigned int TargetSearch::other() const
  {
    if (own_ == 0 || own_ == most)
      return own_ == 0 ? 1 : most - 1;
    return up_ ? own_ + 1 : own_ - 1;
  }


  void TargetSearch::accept(const double length, const unsigned int iterations)
  {
    if (count_ >= that_do_not_count)
    {
      Cost &cost = costs_[tries_other() ? 1 : 0];
      cost.iterations += iterations;
      cost.length += length;
    }
    if (++count_ < increments_of_block)
      return;
    count_ = 0;
    if (++block_ < blocks)
      return;
    block_ = 0;
    const auto &[own, other_one] = costs_;
    if (other_one.iterations * own.length < own.iterations * other_one.length)
      own_ = other();
    else
      up_ = !up_;
    costs_ = {};
  }
} // namespace deltaform
