#pragma once

#include "rate_decorator.h"

namespace deltaform
{
  /**
   * A rate factor that counts the heat of the flow, of a metal that conducts: between the increments heat comes and
   * goes, so that the metal may become colder than it was at its start. What the law makes of a temperature is its own
   * affair.
   */
  class ConductedHeat final : public RateDecorator
  {
  public:
    /// @p law with the field `temperature_rise` in its history, which may be negative
    ConductedHeat(std::unique_ptr<RateFactor> law, const MetalHeat &metal);

    HistoryLayout history_layout() const override;
    bool needs_duration() const override;
    std::optional<MetalHeat> heat() const override;

  private:
    MetalHeat metal_;
  };
} // namespace deltaform
