#include <deltaform/increment/pace.h>
#include <deltaform/parameters/text.h>

#include <algorithm>

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


  std::string Pace::never_ends(const double end, const unsigned int most) const
  {
    // The longest random scenes that come to their ends had up to 34 000 left in a bad thousand (doc/decisions).
    constexpr double far_too_many = 5e4;
    const double more = left(end);
    if (more <= std::max(far_too_many, double(most)))
      return "";
    return "at the pace of the last " + std::to_string(window) + " increments the stage takes " + text::rounded(more) +
           " more: they are solved, but with too many iterations, or only because they are so short. Look at the last "
           "picture. Try shorter elements at radii and where contact begins and ends, a larger allowed penetration, or "
           "a larger Solver/Target iterations";
  }
} // namespace deltaform
