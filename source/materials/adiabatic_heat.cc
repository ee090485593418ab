#include "adiabatic_heat.h"

#include <cmath>
#include <utility>

namespace deltaform
{
  AdiabaticHeat::AdiabaticHeat(std::unique_ptr<RateFactor> cold,
                               std::unique_ptr<Softening> softening,
                               const double heating,
                               const std::optional<MetalHeat> &conducts)
    : RateDecorator(std::move(cold)), softening_(std::move(softening)), heating_(heating), conducts_(conducts),
      rise_(law().history_layout().size())
  {
  }


  HistoryLayout AdiabaticHeat::history_layout() const
  {
    HistoryLayout layout = law().history_layout();
    layout.append({{"temperature_rise", conducts_ ? HistoryKind::scalar : HistoryKind::positive, "temperature"}});
    return layout;
  }


  bool AdiabaticHeat::needs_duration() const
  {
    return conducts_ || law().needs_duration();
  }


  bool AdiabaticHeat::knows_first_stress() const
  {
    return law().needs_duration();
  }


  bool AdiabaticHeat::softens() const
  {
    return true;
  }


  std::optional<MetalHeat> AdiabaticHeat::heat() const
  {
    return conducts_;
  }


  double AdiabaticHeat::rise(const double *const history) const
  {
    return conducts_ ? history[rise_] : std::fmax(history[rise_], 0.);
  }


  std::array<FlowStress, HeatStages::n>
  AdiabaticHeat::cold_stages(const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const
  {
    std::array<FlowStress, HeatStages::n> result;
    WholeFlow whole = flow.whole;
    if (std::isfinite(whole.first_stress))
    {
      const FlowStress slow_first{whole.slow->evaluate(flow.strain - whole.growth).value, 0.};
      const double factor = softening_->evaluate(rise(whole.committed)).factor;
      for (unsigned int repeated = 0; repeated < HeatStages::rate_corrections; ++repeated)
      {
        const FlowStress cold = law().evaluate(
          slow_first, {flow.strain, whole.growth, whole.mean_rate, whole.mean_rate_by_growth, whole}, start, end);
        whole = flow.whole.since_yield({factor * cold.value, factor * cold.slope});
      }
    }
    for (unsigned int i = 0; i < HeatStages::n; ++i)
    {
      const double c = HeatStages::place[i], strain = flow.strain - (1. - c) * whole.growth;
      FlowStress at = i + 1 < HeatStages::n ? whole.slow->evaluate(strain) : slow;
      at.slope *= c;
      result[i] =
        law().evaluate(at, {strain, c * whole.growth, whole.mean_rate, whole.mean_rate_by_growth, whole}, start, end);
    }
    return result;
  }


  FlowStress AdiabaticHeat::evaluate(
    const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const
  {
    const auto stages = cold_stages(slow, flow, start, end);
    const auto hot = [&](const unsigned int stage, const double rise) -> HotStress {
      const FlowStress &cold = stages[stage];
      const Softened soft = softening_->evaluate(rise);
      return {soft.factor * cold.value, soft.factor * cold.slope, soft.slope * cold.value};
    };
    const HeatedEnd heated = balance_heat(stages, hot, rise(flow.whole.committed), heating_, flow.whole.growth);
    end[rise_] = heated.rise;
    const FlowStress cold = law().evaluate(slow, flow, start, end);
    const Softened soft = softening_->evaluate(heated.rise);
    const double value = soft.factor * cold.value;
    if (std::isinf(cold.slope))
      return {value, cold.slope};
    return {value, soft.factor * cold.slope + soft.slope * cold.value * heated.by_growth};
  }


  double AdiabaticHeat::at_rest(const double slow, const double strain, const double *const history) const
  {
    return softening_->evaluate(rise(history)).factor * law().at_rest(slow, strain, history);
  }
} // namespace deltaform
