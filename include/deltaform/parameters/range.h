#pragma once

#include <limits>
#include <string>

namespace deltaform
{
  /// Allowed values of a number. Infinite bounds are no bounds; an exclusive bound is not itself allowed.
  struct Range
  {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool lower_exclusive = false;
    bool upper_exclusive = false;

    static Range any()
    {
      return {};
    }
    static Range positive()
    {
      return {0., std::numeric_limits<double>::infinity(), true, false};
    }
    static Range not_negative()
    {
      return {0., std::numeric_limits<double>::infinity(), false, false};
    }
    static Range between(const double a, const double b)
    {
      return {a, b, false, false};
    }
    static Range inside(const double a, const double b)
    {
      return {a, b, true, true};
    }
    static Range from_to_below(const double a, const double b)
    {
      return {a, b, false, true};
    }
    static Range above_to(const double a, const double b)
    {
      return {a, b, true, false};
    }

    bool contains(double value) const;
    std::string to_string() const; ///< for example "(0, 0.5)"
  };
} // namespace deltaform
