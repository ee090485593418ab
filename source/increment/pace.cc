#include <deltaform/increment/pace.h>

namespace deltaform
{
  void Pace::accept(const double time)
  {
    times_.push_back(time);
    if (times_.size() > window + 1)
      times_.pop_front();
  }


  double Pace::left(const double end) const
  {
    if (times_.size() <= window)
      return 0.;
    return (end - times_.back()) / (times_.back() - times_.front()) * window;
  }
} // namespace deltaform
