#pragma once

#include <deltaform/increment/increment.h>

#include <limits>

namespace deltaform
{
  /// Of the attempts at an increment that failed the shortest. It says why there is no way on: longer ones that are
  /// tried after it end beyond a snap, if at all, and fail for reasons of their own.
  class ShortestFailure
  {
  public:
    void add(const Rejected &rejected, const double length)
    {
      if (length >= length_)
        return;
      reason_ = rejected;
      length_ = length;
    }

    /// To be asked for after a failure.
    const Rejected &reason() const
    {
      return reason_;
    }

  private:
    Rejected reason_{};
    double length_ = std::numeric_limits<double>::infinity();
  };
} // namespace deltaform
