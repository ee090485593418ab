#pragma once

#include <deltaform/materials/plasticity.h>

namespace deltaform
{
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
    return laws.rate_factor->evaluate(slow, {strain, x, law.duration}, point.start + rate_first,
                                      point.trial + rate_first);
  }
} // namespace deltaform
