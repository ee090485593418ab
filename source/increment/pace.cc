#include <deltaform/increment/pace.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <numeric>

namespace deltaform
{
  void Pace::accept(const double time, const unsigned int iterations)
  {
    last_.push_back({time, double(iterations)});
    if (last_.size() > window + 1)
      last_.erase(last_.begin());
  }


  double Pace::left(const double end) const
  {
    if (!is_known())
      return 0.;
    return (end - last_.back().time) / (last_.back().time - last_.front().time) * window;
  }


  double Pace::iterations_left(const double end) const
  {
    if (!is_known())
      return 0.;
    const double spent = std::accumulate(last_.begin() + 1, last_.end(), 0., [](const double sum, const Accepted &one) {
      return sum + one.iterations;
    });
    return left(end) / window * spent;
  }


  std::string Pace::never_ends(const double end, const unsigned int most) const
  {
    // The longest random scenes that come to their ends had up to 34 000 left in a bad thousand (doc/decisions, "When a
    // run crawls").
    constexpr double far_too_many = 5e4, iterations_of_one = 10.;
    const double more = left(end), iterations = iterations_left(end), allowed = std::max(far_too_many, double(most));
    if (more <= allowed && iterations <= iterations_of_one * allowed)
      return "";
    return "at the pace of the last " + std::to_string(window) + " increments the stage takes " + text::rounded(more) +
           " more, with " + text::rounded(iterations) + " Newton iterations: they are solved, but with too many iterations, or only because they are so short. Look at the last "
           "picture. Try shorter elements at radii and where contact begins and ends, a larger allowed penetration, or "
           "a larger Solver/Target iterations";
  }
} // namespace deltaform
