#pragma once

#include <deltaform/materials/plasticity.h>

#include <cmath>

namespace deltaform
{
  /// A rate of the equivalent plastic strain at the end of an increment, and its slope.
  struct FlowRate
  {
    double value; ///< (1/time)
    double by_growth; ///< d value/dx
  };

  /**
   * The rate after the growth x from the start of the return map: x over its share of the duration. With BDF2 this
   * is linear in the mean rates m_0 of the last and m_1 of this increment, r = m_1 + (m_1 - m_0) w/(1 + w), w the
   * ratio of their lengths. Where the rate falls, r = m_1 (m_1/m_0)^(w/(1 + w)) takes its place: with the same value
   * and slope at m_1 = m_0, of second order as well, and never below zero. The flow of metal that relaxes decays like a
   * power of time: its error is a tenth.
   */
  inline FlowRate flow_rate(const FlowLaw &law, const PointUpdate &point, const double x)
  {
    const double by_growth = 1. / (law.share * law.duration);
    const double before = point.start[FlowHistory::equivalent] - point.committed[FlowHistory::equivalent];
    const double mean = (before + x) / law.duration, last = before / ((1. - law.share) * law.duration);
    if (!(law.share < 1. && before > 0. && mean < last))
      return {x * by_growth, by_growth};
    const double falls = std::pow(mean / last, (1. - law.share) / law.share);
    return {mean * falls, by_growth * falls};
  }


  /// Flow stress after @p x more of equivalent plastic strain, at the rate of that in the increment.
  /// @param rate_first where the history of the rate factor begins
  inline FlowStress rate_dependent_flow_stress(const FlowLaws &laws,
                                               const FlowLaw &law,
                                               const PointUpdate &point,
                                               const unsigned int rate_first,
                                               const double x)
  {
    const double strain = point.start[FlowHistory::equivalent] + x;
    const FlowStress slow = law.hardening.evaluate(strain);
    if (!laws.rate_factor)
      return slow;
    const FlowRate rate = flow_rate(law, point, x);
    const double growth = strain - point.committed[FlowHistory::equivalent];
    const WholeFlow whole{&law.hardening,
                          point.committed + rate_first,
                          growth,
                          growth / law.duration,
                          1. / law.duration,
                          law.first_stress,
                          3. * law.elastic.shear,
                          law.duration};
    return laws.rate_factor->evaluate(
      slow, {strain, x, rate.value, rate.by_growth, whole}, point.start + rate_first, point.trial + rate_first);
  }
} // namespace deltaform
