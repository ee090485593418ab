#include "conducted_heat.h"

#include <utility>

namespace deltaform
{
  ConductedHeat::ConductedHeat(std::unique_ptr<RateFactor> law, const MetalHeat &metal)
    : law_(std::move(law)), metal_(metal)
  {
  }


  HistoryLayout ConductedHeat::history_layout() const
  {
    const HistoryLayout own = law_->history_layout();
    HistoryLayout layout;
    for (HistoryField field : own.fields())
    {
      if (field.name == "temperature_rise")
        field.kind = HistoryKind::scalar;
      layout.append(HistoryLayout{field});
    }
    return layout;
  }


  bool ConductedHeat::needs_duration() const
  {
    return true;
  }


  bool ConductedHeat::softens() const
  {
    return law_->softens();
  }


  std::optional<MetalHeat> ConductedHeat::heat() const
  {
    return metal_;
  }


  FlowStress ConductedHeat::evaluate(
    const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const
  {
    return law_->evaluate(slow, flow, start, end);
  }


  double ConductedHeat::at_rest(const double slow, const double strain, const double *const history) const
  {
    return law_->at_rest(slow, strain, history);
  }
} // namespace deltaform
