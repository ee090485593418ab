#include "adiabatic_heat.h"

#include <cmath>
#include <utility>

namespace deltaform
{
  AdiabaticHeat::AdiabaticHeat(std::unique_ptr<RateFactor> cold,
                               std::unique_ptr<Softening> softening,
                               const double heating,
                               const std::optional<MetalHeat> &conducts)
    : cold_(std::move(cold)), softening_(std::move(softening)), heating_(heating), conducts_(conducts),
      rise_(cold_->history_layout().size())
  {
  }


  HistoryLayout AdiabaticHeat::history_layout() const
  {
    HistoryLayout layout = cold_->history_layout();
    layout.append({{"temperature_rise", conducts_ ? HistoryKind::scalar : HistoryKind::positive, "temperature"}});
    return layout;
  }


  bool AdiabaticHeat::needs_duration() const
  {
    return conducts_ || cold_->needs_duration();
  }


  bool AdiabaticHeat::softens() const
  {
    return true;
  }


  std::optional<MetalHeat> AdiabaticHeat::heat() const
  {
    return conducts_;
  }


  FlowStress AdiabaticHeat::evaluate(
    const FlowStress &slow, const double flow, const double duration, const double *start, double *end) const
  {
    constexpr unsigned int max_iter = 100;
    const FlowStress cold = cold_->evaluate(slow, flow, duration, start, end);
    const double before = conducts_ ? start[rise_] : std::fmax(start[rise_], 0.), k = heating_ * flow;
    // g(s) = s - f(T + k s) s_cold grows from g(0) <= 0 to g(f(T) s_cold) >= 0: Newton inside this bracket, else
    // halves. f(T) <= 1 but where the metal was cooled.
    double lower = 0., upper = cold.value * (before < 0. ? softening_->evaluate(before).factor : 1.), s = upper;
    Softened soft = softening_->evaluate(before + k * s);
    for (unsigned int iteration = 0; iteration < max_iter; ++iteration)
    {
      const double g = s - soft.factor * cold.value;
      (g > 0. ? upper : lower) = s;
      double next = s - g / (1. - k * soft.slope * cold.value);
      if (!(next >= lower && next <= upper))
        next = .5 * (lower + upper);
      const bool close = std::abs(next - s) <= 1e-15 * cold.value;
      s = next;
      soft = softening_->evaluate(before + k * s);
      if (close)
        break;
    }
    end[rise_] = before + k * s;
    // ds = f ds_cold + s_cold f' (heating s dx + k ds)
    if (std::isinf(cold.slope))
      return {s, cold.slope};
    const double by_heat = cold.value * soft.slope;
    return {s, (soft.factor * cold.slope + by_heat * heating_ * s) / (1. - by_heat * k)};
  }
} // namespace deltaform
