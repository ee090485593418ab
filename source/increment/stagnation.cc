#include <deltaform/increment/stagnation.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  bool Stagnation::reached(const std::vector<double> &residuals, const bool is_patient) const
  {
    constexpr double enough = .5;
    const unsigned int n = is_patient ? long_window : window;
    if (residuals.size() <= n)
      return false;
    const auto last = residuals.end() - n;
    const double now = *std::min_element(last, residuals.end());
    const double ratio = now / *std::min_element(residuals.begin(), last);
    if (residuals.back() >= near)
      return ratio > enough;
    const double windows_left = (most_iterations - (residuals.size() - 1.)) / n;
    return now > tolerance && now * std::pow(std::min(ratio, 1.), std::max(windows_left, 0.)) > tolerance;
  }
} // namespace deltaform
