#pragma once

#include <cmath>

namespace deltaform
{
  /// A flow stress at the temperature that its own work makes.
  struct HeatedStress
  {
    double value; ///< s
    double slope; ///< d s/d temperature at a given rest of the state, not positive
    double rise; ///< of the temperature at the end
  };


  /**
   * Backward Euler of adiabatic heating: s = f(T_n + k s), where f(rise).value is the flow stress at a rise of the
   * temperature and f(rise).slope its derivative, which is not positive. T_n = @p before, @p k rise per stress, not
   * negative. s - f grows from g(0) <= 0 to g(f(T_n)) >= 0: Newton's iteration inside this bracket, else halves.
   */
  template <typename Function>
  HeatedStress balance_heat(const Function &f, const double before, const double k)
  {
    constexpr unsigned int max_iter = 100;
    const double most = f(before).value;
    double lower = 0., upper = most, s = upper;
    auto at = f(before + k * s);
    for (unsigned int iteration = 0; iteration < max_iter; ++iteration)
    {
      const double g = s - at.value;
      (g > 0. ? upper : lower) = s;
      double next = s - g / (1. - k * at.slope);
      if (!(next >= lower && next <= upper))
        next = .5 * (lower + upper);
      const bool close = std::abs(next - s) <= 1e-15 * most;
      s = next;
      at = f(before + k * s);
      if (close)
        break;
    }
    return {s, at.slope, before + k * s};
  }
} // namespace deltaform
