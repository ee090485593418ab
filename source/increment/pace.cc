#include <deltaform/increment/pace.h>
#include <deltaform/parameters/text.h>

#include <algorithm>

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
    if (last_.empty())
      return 0.;
    double spent = 0.;
    auto first = last_.end() - 1; // where what is counted began
    for (; first != last_.begin() && spent < effort; --first)
      spent += first->iterations;
    if (!is_known() && spent < effort)
      return 0.;
    return (end - last_.back().time) / (last_.back().time - first->time) * spent;
  }


  std::string Pace::never_ends(const double end, const unsigned int most) const
  {
    // The longest random scenes that come to their ends had up to 43 000 and 860 000 left (doc/decisions/README.md,
    // "When a run crawls").
    constexpr double far_too_many = 5e4, iterations_of_one = 40.;
    const double more = left(end), iterations = iterations_left(end), allowed = std::max(far_too_many, double(most));
    if (more <= allowed && iterations <= iterations_of_one * allowed)
      return "";
    return "at the pace of the last " +
           (more > allowed ? std::to_string(window) + " increments the stage takes " + text::rounded(more)
                           : std::to_string(effort) + " Newton iterations the stage takes " + text::rounded(iterations)) +
           " more: increments are solved, but with too many iterations, or only because they are so short. Look at the "
           "last picture. Try shorter elements at radii and where contact begins and ends, a larger allowed "
           "penetration, or a larger Solver/Target iterations";
  }
} // namespace deltaform
