#include "adiabatic_heat.h"

#include "heat_balance.h"

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


  FlowStress AdiabaticHeat::evaluate(
    const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const
  {
    const FlowStress cold = law().evaluate(slow, flow, start, end);
    const double k = heating_ * flow.growth;
    double factor = 1.;
    const auto stress = [&](const double rise) -> FlowStress {
      const Softened soft = softening_->evaluate(rise);
      factor = soft.factor;
      return {soft.factor * cold.value, soft.slope * cold.value};
    };
    const HeatedStress hot = balance_heat(stress, rise(start), k);
    end[rise_] = hot.rise;
    // ds = f ds_cold + s_cold f' (heating s dx + k ds)
    if (std::isinf(cold.slope))
      return {hot.value, cold.slope};
    return {hot.value, (factor * cold.slope + hot.slope * heating_ * hot.value) / (1. - hot.slope * k)};
  }


  double AdiabaticHeat::at_rest(const double slow, const double strain, const double *const history) const
  {
    return softening_->evaluate(rise(history)).factor * law().at_rest(slow, strain, history);
  }
} // namespace deltaform
