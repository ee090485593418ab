#include <deltaform/increment/target_search.h>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int most = 3; // more than the least
  } // namespace


  unsigned int TargetSearch::other() const
  {
    if (own_ == 0 || own_ == most)
      return own_ == 0 ? 1 : most - 1;
    return up_ ? own_ + 1 : own_ - 1;
  }


  void TargetSearch::accept(const double length, const unsigned int iterations)
  {
    const auto other_is_faster = comparison_.accept(length, iterations);
    if (!other_is_faster)
      return;
    if (*other_is_faster)
      own_ = other();
    else
      up_ = !up_;
  }
} // namespace deltaform
