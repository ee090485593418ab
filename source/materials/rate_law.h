#pragma once

#include <deltaform/materials/rate_factor.h>
#include <deltaform/materials/read_law.h>
#include <deltaform/parameters/registry.h>

#include <memory>
#include <utility>

namespace deltaform
{
  /// The flow stress at a rate of the equivalent plastic strain.
  struct RateStress
  {
    double value;
    double by_slow; ///< d value / d slow flow stress
    double by_rate; ///< d value / d rate; may be infinite at rate 0
  };


  /// The rate factor of a value @p Law with `RateStress operator()(double slow_flow_stress, double rate) const`.
  template <typename Law>
  class RateFactorOf final : public RateFactor
  {
  public:
    explicit RateFactorOf(const Law &law)
      : law_(law)
    {
    }

    HistoryLayout history_layout() const override
    {
      return {};
    }

    FlowStress evaluate(const FlowStress &slow, const PointFlow &flow, const double *, double *) const override
    {
      const RateStress at = law_(slow.value, flow.rate);
      return {at.value, at.by_slow * slow.slope + at.by_rate * flow.rate_by_growth};
    }

  private:
    Law law_;
  };


  /// The maker that registers a value as a rate factor.
  template <typename Law>
  std::unique_ptr<RateFactor> rate_factor_from(Section &section)
  {
    return std::make_unique<RateFactorOf<Law>>(read_law<Law>(section));
  }
} // namespace deltaform
