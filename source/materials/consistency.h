#pragma once

#include <cmath>
#include <limits>

namespace deltaform
{
  /// By how much the yield condition is violated after plastic flow u, relative to the stress, and d value / d u.
  struct Excess
  {
    double value;
    double slope;
  };

  /// Amount of plastic flow at which the yield condition is met; 0 if it is not violated in the first place.
  struct PlasticFlow
  {
    double amount = 0.;
    bool found = false; ///< false: not a number, or no convergence
    bool resolved = true; ///< false: met as closely as neighbouring floating-point numbers allow, but not more
  };

  /// Between what the root of solve_consistency() lies, and how it is cut.
  struct ConsistencyBracket
  {
    double upper, lower = 0.;
    double reach = 1e-4; ///< how far down to cut while nothing is known but that the root is not 0
    unsigned int slow = 0; ///< extrapolations without a cut

    bool inside(const double u) const
    {
      return u > lower && u < upper;
    }

    /// Less what lies beyond @p u with the excess @p f; false if that is not a number.
    bool narrow(const double u, const double f)
    {
      (f > 0. ? lower : upper) = u;
      return !std::isnan(f);
    }

    /// @p extrapolated, or a cut at the geometric mean (from 0 upwards: by factors that grow).
    double shorten(const double extrapolated)
    {
      if (slow < 2 && inside(extrapolated))
      {
        ++slow;
        return extrapolated;
      }
      slow = 0;
      if (lower > 0.)
        return upper < std::numeric_limits<double>::infinity() ? std::sqrt(lower) * std::sqrt(upper) : 1e3 * lower;
      const double cut = std::fmax(reach * upper, std::numeric_limits<double>::min());
      reach = std::fmax(reach * reach, 1e-64);
      return cut;
    }
  };


  /**
   * Solve f(u) = 0, u >= 0, for a continuous f(u) that goes from f(0) > 0 to f(@p upper) <= 0 (@p upper may be
   * infinite) to |f| <= @p tolerance. @p guess is where the root is believed to be (anything else than a number in
   * (0, upper) means no idea), @p start a finite number in (0, upper] to begin with if the slope at 0 is unbounded.
   *
   * Newton's iteration inside a bracket. Where it leaves the bracket or converges slowly, f(0) - f(u) is taken for a
   * power of u and extrapolated as such (Newton in log-log coordinates; exact for power laws, whose slope is
   * unbounded at u = 0, however small the root); where that leaves the bracket, the bracket is cut at its geometric
   * mean (from 0 upwards: by factors that grow, so that a root of 1e-300 is found as well). After any return other than
   * 0, the last call of @p excess was at the amount returned.
   */
  template <typename Function>
  PlasticFlow solve_consistency(const Function &excess,
                                const double guess,
                                const double start,
                                const double upper,
                                const double tolerance = 2e-15)
  {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    constexpr unsigned int max_iter = 200;

    ConsistencyBracket bracket{upper};
    double at_zero = not_a_number, u = guess;
    if (!(guess > 0. && guess < upper))
    {
      const Excess zero = excess(0.);
      at_zero = zero.value;
      if (!(at_zero > tolerance))
        return {0., at_zero <= tolerance, true};
      u = at_zero / -zero.slope;
      if (!(u > 0. && u < upper))
        u = start;
    }

    double previous = std::numeric_limits<double>::infinity();
    for (unsigned int iteration = 0; iteration < max_iter; ++iteration)
    {
      const Excess here = excess(u);
      const double f = here.value;
      const double size_f = std::abs(f);
      if (size_f <= tolerance)
        return {u, true, true};
      if (!bracket.narrow(u, f))
        return {};

      double next = u - f / here.slope;
      if (!bracket.inside(next) || size_f > .25 * previous)
      {
        if (std::isfinite(here.slope) && std::abs(next - u) <= std::numeric_limits<double>::epsilon() * u)
          return {u, true, size_f <= 100. * tolerance};
        if (std::isnan(at_zero))
        {
          at_zero = excess(0.).value;
          if (!(at_zero > tolerance))
            return {0., at_zero <= tolerance, true};
        }
        const double flow = at_zero - f;
        next = bracket.shorten(u * std::pow(at_zero / flow, -flow / (here.slope * u)));
        if (!bracket.inside(next)) // no floating-point number is left inside the bracket
        {
          excess(u);
          return {u, true, size_f <= 100. * tolerance};
        }
      }
      previous = size_f;
      u = next;
    }
    return {};
  }
} // namespace deltaform
