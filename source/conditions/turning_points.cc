#include <deltaform/conditions/turning_points.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  void TurningPoints::add(const double value)
  {
    constexpr double resolution = .05;
    if (is_empty_)
      lowest_ = highest_ = value;
    is_empty_ = false;
    largest_ = std::max(largest_, std::abs(value));
    go_to(value, resolution * largest_);
  }


  void TurningPoints::go_to(const double value, const double least)
  {
    const std::size_t n = turns_.size();
    if (n == 0)
    {
      lowest_ = std::min(lowest_, value);
      highest_ = std::max(highest_, value);
      if (highest_ - lowest_ >= least)
        turns_ = {value == highest_ ? lowest_ : highest_, value};
      return;
    }
    const double way = value - turns_[n - 1];
    if (way * (turns_[n - 1] - turns_[n - 2]) >= 0.)
      turns_[n - 1] = value;
    else if (std::abs(way) >= least)
      turns_.push_back(value);
  }


  std::vector<double> TurningPoints::swings(const double least) const
  {
    TurningPoints large;
    if (!turns_.empty())
      large.lowest_ = large.highest_ = turns_.front();
    for (const double value : turns_)
      large.go_to(value, least);
    std::vector<double> result;
    for (std::size_t i = 2; i + 1 < large.turns_.size(); ++i)
      result.push_back(std::abs(large.turns_[i] - large.turns_[i - 1]));
    return result;
  }
} // namespace deltaform
