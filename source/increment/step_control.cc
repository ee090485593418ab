#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    // Shares of a usual increment. doc/decisions/README.md, "Waiting with longer increments"
    constexpr double far_too_short = .01;
    constexpr double crawling = 1e-3;
    constexpr unsigned int dear = 2; ///< times the iterations aimed at
  } // namespace


  StepSettings::StepSettings(Section &section, const unsigned int target)
    : target_iterations(section.integer("Target iterations", static_cast<int>(target), 1, 1000,
                                        "Newton iterations aimed at: more shorten the next increment, fewer lengthen "
                                        "it. Up to three more are aimed at where the stage moves faster with them. "
                                        "Default is 5 for a shell, 8 for a solid.")),
      growth(section.number("Growth", 1.5, Range{1., 10., false, false}, "1",
                            "Largest factor from one increment to the next.")),
      shrink(section.number("Shrink", .5, Range::inside(0, 1), "1", "Factor of the increment after a failure.")),
      largest_strain(section.number("Largest strain increment",
                                    .1,
                                    Range::positive(),
                                    "1",
                                    "An increment that strains any point by more is repeated with a smaller size.")),
      largest_rotation(section.number("Largest rotation increment",
                                      .3,
                                      Range::positive(),
                                      "rad",
                                      "An increment that turns any node by more is repeated with a smaller size.")),
      max_increments(section.integer("Maximal increments",
                                     10000,
                                     1,
                                     1000000000,
                                     "Increments of the whole run; then it stops with status 2 and can be resumed. "
                                     "So it does where a stage, at the pace of its last 1000, takes fifty thousand "
                                     "more, and more than these, or forty times as many Newton iterations.")),
      flow_error(
        section.number("Flow error",
                       0.,
                       Range{0., 1., false, true},
                       "1",
                       "Largest relative error of the plastic strain that an increment adds, estimated from the turn "
                       "of its direction; increments are made as long as this allows. 0: not used.")),
      extrapolate(section.flag("Extrapolate", true,
                               "Predictor: an increment starts where the last three states lead."))
  {
  }


  StepControl::StepControl(const StepSettings &settings,
                           const double begin,
                           const double end,
                           const double first,
                           const double smallest,
                           const double largest,
                           const std::vector<double> &meet)
    : settings_(settings), end_(end), smallest_(smallest), largest_(largest),
      usual_(std::min(largest, usual_share * (end - begin))), increment_(std::clamp(first, smallest, largest))
  {
    for (const double time : meet)
      if (time > begin && time < end)
        meet_.push_back(time);
    meet_.push_back(end);
  }


  double StepControl::next(const double time) const
  {
    const double target = *std::upper_bound(meet_.begin(), meet_.end(), time);
    const double left = target - time;
    if (left <= increment_ * (1 + 1e-9))
      return target;
    // Two equal increments instead of one and a sliver.
    return left < 2 * increment_ ? time + .5 * left : time + increment_;
  }


  void StepControl::accept(const std::optional<unsigned int> iterations, const double error, const double longest,
                           const unsigned int spent)
  {
    constexpr double safety = .8; // the next increment may strain faster
    const double last = increment_;
    failed_.accept(last);
    search_.accept(last, spent);
    if (iterations)
    {
      resize(*iterations, error);
      // Where increments are so short (a neck, a snap) to wait with longer ones never ends. Where they are short and
      // dear it costs more than another failure.
      const bool is_short = last < far_too_short * usual_;
      const bool is_dear = *iterations > dear * settings_.target_iterations;
      if (last > crawling * usual_ && !(is_short && is_dear))
        increment_ = failed_.bounded(increment_, last);
    }
    else
      take_back_cuts();
    shorten(safety * longest);
  }


  void StepControl::shorten(const double longest)
  {
    increment_ = std::max(std::min(increment_, longest), smallest_);
  }


  void StepControl::take_back_cuts()
  {
    longer_tries_ = quiet_ = shortened_ = 0;
    const double uncut = increment_ / std::pow(settings_.shrink, cuts_before_last_resorts);
    increment_ = std::min(settings_.growth * uncut, largest_);
  }


  void StepControl::resize(const unsigned int iterations, const double error)
  {
    constexpr double integral = .3, proportional = .4;
    longer_tries_ = 0;
    const double last = error_ > 0. ? error_ : error;
    error_ = error;
    double by_error = settings_.growth;
    if (settings_.flow_error > 0. && error > 0.)
      by_error = std::pow(settings_.flow_error / error, integral) * std::pow(last / error, proportional);
    if (quiet_ > 0)
    {
      --quiet_;
      return;
    }
    const double target = search_.target(settings_.target_iterations);
    double ratio = std::sqrt(target / std::max(iterations, 1u));
    // An increment that is far too short, or a shorter one that took as many: it is not its length that makes the
    // iterations, and ever shorter ones never end. Lightly loaded nodes that come and go do that.
    if (increment_ < far_too_short * usual_)
      ratio = settings_.growth;
    else if (ratio >= 1)
      shortened_ = 0;
    else if (shortened_ > 0 && iterations >= shortened_)
      ratio = 1.;
    else
      shortened_ = iterations;
    ratio = std::min(ratio, by_error);
    increment_ = std::clamp(increment_ * std::clamp(ratio, settings_.shrink, settings_.growth), smallest_, largest_);
  }


  bool StepControl::reject(const double tried)
  {
    const double shorter = tried * settings_.shrink;
    quiet_ = 1;
    failed_.reject();
    if (longer_tries_ == 0 && shorter >= smallest_)
    {
      increment_ = shorter;
      return true;
    }
    // At a place where the blank snaps through a longer increment may lead to the equilibrium beyond. The longest of
    // all is tried once.
    if (longer_tries_ == most_longer_tries || (longer_tries_ > 0 && tried >= (1. - 1e-9) * largest_))
      return false;
    ++longer_tries_;
    increment_ = std::min(10. * tried, largest_);
    return true;
  }


  Effort StepControl::effort(const double length, const unsigned int cutbacks, const bool continues) const
  {
    // As short as it may be: the length of the increment is not the reason. Nor is it after two cuts, or where
    // increments are so short. doc/decisions/README.md, "Increments that creep towards a snap"
    if (length * settings_.shrink < smallest_)
      return Effort::all;
    if (cutbacks >= cuts_before_last_resorts || longer_tries_ > 0 || length < crawling * usual_)
      return Effort::last_resorts;
    return cutbacks == 0 && continues ? Effort::first : Effort::usual;
  }


  void StepControl::restore(const State &state)
  {
    increment_ = state.increment > smallest_ ? std::min(state.increment, largest_) : smallest_;
    quiet_ = state.quiet;
    shortened_ = state.shortened;
    error_ = state.error;
    failed_ = state.failed;
    search_ = state.search;
  }


  bool StepControl::finished(const double time) const
  {
    return time >= end_;
  }
} // namespace deltaform
