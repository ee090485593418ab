#include <deltaform/increment/radius_search.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double longest = 1.2, shortest = .5, aim = .8; ///< times the radius
    constexpr unsigned int most_solves = 7;
    constexpr double first = .01; ///< share of force/radius that is tried before anything is known
    constexpr double least = 1e-3; ///< of force/radius; below, the step without is tried
    constexpr double most_growth = 30., most_fall = 20.;
  } // namespace


  bool RadiusSearch::is_within(const double radius, const double length)
  {
    return length <= longest * radius;
  }


  bool RadiusSearch::find(const double radius, const double force, const Length &length_at)
  {
    const double most = force / radius; // 0 if the radius is infinite
    double mu = last_.mu > 0. ? std::min(last_.mu * last_.length / radius, most) : first * most;
    Tried too_long, too_short;
    for (unsigned int n = 1;; ++n)
    {
      const std::optional<double> length = length_at(mu);
      if (!length)
        return false;
      last_ = {mu, *length};
      if (!is_within(radius, last_.length))
        too_long = last_;
      else if (last_.length < shortest * radius && mu > 0.)
        too_short = last_;
      else
        return true;
      mu = next(too_long, too_short, radius, most);
      // Where K is indefinite no mu need be enough.
      if (n == most_solves || mu == last_.mu)
        return true;
    }
  }


  double
  RadiusSearch::next(const Tried &too_long, const Tried &too_short, const double radius, const double most)
  {
    const double wanted = aim * radius;
    if (too_long.length == 0.)
      return too_short.mu > least * most ? too_short.mu * std::max(1. / most_fall, too_short.length / wanted) : 0.;
    if (too_short.length == 0. && too_long.mu == 0.)
      return first * most;
    if (too_short.length == 0.)
      return std::min(most, too_long.mu * std::min(most_growth, too_long.length / wanted));
    if (too_long.mu == 0.) // 1/|d| is nearly linear in mu
      return too_short.mu * std::max(1. / most_fall,
                                     (1. / wanted - 1. / too_long.length) /
                                       (1. / too_short.length - 1. / too_long.length));
    const double share = std::log(too_long.length / wanted) / std::log(too_long.length / too_short.length);
    return too_long.mu * std::pow(too_short.mu / too_long.mu, std::clamp(share, .1, .9));
  }
} // namespace deltaform
