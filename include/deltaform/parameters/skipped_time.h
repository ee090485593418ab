#pragma once

#include <deltaform/parameters/time_function.h>

#include <vector>

namespace deltaform
{
  /**
   * Time that a run has skipped: a stage that ended before its end time. The next stage begins at the time that the
   * scene gives it; functions of time go on from the values that they had, shifted by a constant.
   */
  class SkippedTime
  {
  public:
    void add(const double from, const double to)
    {
      times_.push_back(from);
      times_.push_back(to);
    }

    /// Value of a function at a time: after the skipped time it goes on from the value that it had.
    double value(const TimeFunction &function, const double time) const
    {
      double result = function(time);
      for (std::size_t i = 0; i < times_.size(); i += 2)
        if (time >= times_[i + 1])
          result += function(times_[i]) - function(times_[i + 1]);
      return result;
    }

    /// Begin and end of each skipped time: from, to, from, to ...
    const std::vector<double> &times() const
    {
      return times_;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &times_;
    }

  private:
    std::vector<double> times_;
  };
} // namespace deltaform
