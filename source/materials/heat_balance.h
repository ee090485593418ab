#pragma once

#include <deltaform/materials/hardening.h>

#include <array>
#include <cmath>

namespace deltaform
{
  /**
   * Places in an increment of plastic strain, as shares of it, whose weighted mean is that of the increment to the
   * fifth power of its length: Radau's, the last one at its end. The steep begin of a flow curve, crossed by the first
   * increment of flow, needs three. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, Springer 1996,
   * sec. IV.5.
   */
  struct HeatStages
  {
    static constexpr unsigned int n = 3;
    static constexpr unsigned int rate_corrections = 2; ///< of the rate where flow begins (WholeFlow::since_yield)
    static constexpr std::array<double, n> place = {{.15505102572168219, .64494897427831781, 1.}};
    static constexpr std::array<double, n> weight = {{.37640306270046726, .51248582618842165, 1. / 9.}};
  };


  /// The flow stress of a stage at the temperature that it has there.
  struct HotStress
  {
    double value;
    double by_growth; ///< d value/dx at a given temperature (stress)
    double by_rise; ///< d value/d temperature (stress/temperature), not positive
  };


  /// Rise of the temperature at the end of an increment.
  struct HeatedEnd
  {
    double rise;
    double by_growth; ///< d rise/dx (temperature)
  };


  /// The mean flow stress of an increment, and its derivatives.
  struct MeanFlowStress
  {
    double value = 0., by_growth = 0., by_rise = 0.;

    /**
     * With the flow stress a_i of the stages at the temperature of the begin, h_i at theirs:
     *
     *     1/M = sum w_i (a_i/h_i) / sum w_i a_i.
     *
     * If heat takes the same share of all, h_i = f(T_i) a_i, this is the equation dT/f = (share/(rho c)) a dx, with
     * both sides integrated by Radau's rule, and the temperature stays below that of f = 0, however large the
     * increment.
     */
    template <typename Hot>
    MeanFlowStress(const std::array<FlowStress, HeatStages::n> &cold,
                   const Hot &hot,
                   const double before,
                   const double warming)
    {
      double mean = 0., inverse = 0., by_cold = 0., by_inverse = 0., by_temperature = 0.;
      for (unsigned int i = 0; i < HeatStages::n; ++i)
      {
        const double c = HeatStages::place[i], w = HeatStages::weight[i], a = cold[i].value;
        const HotStress h = hot(i, before + c * warming);
        if (!(h.value > 0.))
          return;
        const double ratio = a / h.value;
        mean += w * a;
        inverse += w * ratio;
        by_cold += w * cold[i].slope;
        by_inverse += w * (cold[i].slope - ratio * h.by_growth) / h.value;
        by_temperature += w * c * ratio * h.by_rise / h.value;
      }
      value = mean / inverse;
      by_growth = (by_cold - value * by_inverse) / inverse;
      by_rise = value * by_temperature / inverse;
    }
  };


  /**
   * Adiabatic heating over an increment that flows by @p growth: T = T_n + @p heating M(T) @p growth, T_n = @p before,
   * with @p cold the flow stresses of the stages at T_n and their slopes in the growth, @p hot(stage, rise) those at
   * another temperature. T - T_n less the right side grows from below zero at T_n: Newton's iteration inside a bracket,
   * else halves.
   */
  template <typename Hot>
  HeatedEnd balance_heat(const std::array<FlowStress, HeatStages::n> &cold,
                         const Hot &hot,
                         const double before,
                         const double heating,
                         const double growth)
  {
    constexpr unsigned int max_iter = 100;
    constexpr double close = 1e-9; // after one more step of second order: round-off
    const double k = heating * growth;
    const auto mean = [&](const double warming) { return MeanFlowStress(cold, hot, before, warming); };
    MeanFlowStress at = mean(0.);
    const double most = k * at.value;
    if (!(most > 0.))
      return {before, heating * at.value};
    double lower = 0., upper = most, warming = most / (1. - k * at.by_rise);
    for (unsigned int iteration = 0; iteration < max_iter; ++iteration)
    {
      at = mean(warming);
      const double g = warming - k * at.value;
      (g > 0. ? upper : lower) = warming;
      double next = warming - g / (1. - k * at.by_rise);
      if (std::abs(next - warming) <= close * most)
      {
        warming = next;
        break;
      }
      if (!(next > lower && next < upper))
        next = .5 * (lower + upper);
      warming = next;
    }
    return {before + warming, (heating * at.value + k * at.by_growth) / (1. - k * at.by_rise)};
  }
} // namespace deltaform
