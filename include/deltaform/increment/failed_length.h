#pragma once

#include <algorithm>

namespace deltaform
{
  /**
   * Remembers at which length increments have failed. Nothing longer than the last one before a failure is tried again
   * until one increment has been accepted; if the next failure comes soon, 2, 4, ... 64. Else increments that
   * grow after every success fail at the same length again and again.
   */
  class FailedLength
  {
  public:
    void accept(const double length)
    {
      accepted_ = length;
      since_ = std::min(since_ + 1, long_ago);
      wait_ -= std::min(wait_, 1u);
    }

    void reject()
    {
      if (since_ == 0)
        return; // the same increment
      patience_ = since_ <= 2 * patience_ + 4 ? std::min(2 * patience_, most_patience) : 1;
      since_ = 0;
      wait_ = patience_;
      bound_ = accepted_;
    }

    /// The next increment, where @p wanted would follow on one of length @p last.
    double bounded(const double wanted, const double last) const
    {
      return wait_ > 0 ? std::min(wanted, std::max(bound_, last)) : wanted;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &accepted_ &bound_ &since_ &patience_ &wait_;
    }

  private:
    static constexpr unsigned int most_patience = 64, long_ago = 1000;
    double accepted_ = 0., bound_ = 0.; ///< length of the last accepted increment; of the one before the last failure
    unsigned int since_ = long_ago; ///< accepted increments since the last failure
    unsigned int patience_ = 1; ///< those that had to pass after it
    unsigned int wait_ = 0; ///< those that still have to
  };
} // namespace deltaform
