#include <deltaform/geometry/grading.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Where the integral of 1/size from @p a on reaches @p share, at most @p b: Newton's method between two bounds.
    double end_of(const RelativeSize &size, const double a, const double b, const double share)
    {
      double low = a, high = b, x = std::min(b, a + share * size(a));
      while (high - low > 1e-14)
      {
        const double missing = share - element_density(size, a, x);
        (missing > 0. ? low : high) = x;
        constexpr double round_off = 2. * std::numeric_limits<double>::epsilon(); // of x, at most 1
        if (std::abs(missing) < std::max(1e-12 * share, round_off / size(x)))
          break;
        const double next = x + missing * size(x);
        x = next > low && next < high ? next : .5 * (low + high);
      }
      return x;
    }
  } // namespace


  double element_density(const RelativeSize &size, const double a, const double b)
  {
    // Steep gradings and kinks of tables need short intervals; smooth ones are done with one.
    constexpr unsigned int halvings = 15;
    // Over [0, 1]: Boost's tolerance is relative for integrals that are not small.
    return (b - a) * boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
                       [&](const double s) { return 1. / size(a + (b - a) * s); }, 0., 1., halvings, 1e-9);
  }


  std::vector<double> element_ends(const RelativeSize &size, const double a, const double b, const unsigned int n)
  {
    const double whole = element_density(size, a, b);
    std::vector<double> result{a};
    while (result.size() < n)
      result.push_back(end_of(size, result.back(), b, whole / n));
    result.push_back(b);
    return result;
  }
} // namespace deltaform
