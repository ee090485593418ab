#include <deltaform/increment/stagnation.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  bool Stagnation::reached(const std::vector<double> &residuals) const
  {
    constexpr double enough = .5;
    if (residuals.size() <= window)
      return false;
    const auto last = residuals.end() - window;
    const double now = *std::min_element(last, residuals.end());
    const double ratio = now / *std::min_element(residuals.begin(), last);
    if (residuals.back() >= near)
      return ratio > enough;
    const double windows_left = (most_iterations - (residuals.size() - 1.)) / window;
    return now > tolerance && now * std::pow(std::min(ratio, 1.), std::max(windows_left, 0.)) > tolerance;
  }
} // namespace deltaform
