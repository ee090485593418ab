#include "conducted_heat.h"

#include <utility>

namespace deltaform
{
  ConductedHeat::ConductedHeat(std::unique_ptr<RateFactor> law, const MetalHeat &metal)
    : RateDecorator(std::move(law)), metal_(metal)
  {
  }


  HistoryLayout ConductedHeat::history_layout() const
  {
    const HistoryLayout own = law().history_layout();
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


  std::optional<MetalHeat> ConductedHeat::heat() const
  {
    return metal_;
  }
} // namespace deltaform
