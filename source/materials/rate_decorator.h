#pragma once

#include <deltaform/materials/rate_factor.h>

#include <memory>
#include <utility>

namespace deltaform
{
  /// A rate factor that adds to another one; what it does not override is that one's.
  class RateDecorator : public RateFactor
  {
  public:
    HistoryLayout history_layout() const override
    {
      return law_->history_layout();
    }

    bool needs_duration() const override
    {
      return law_->needs_duration();
    }

    bool knows_first_stress() const override
    {
      return law_->knows_first_stress();
    }

    bool softens() const override
    {
      return law_->softens();
    }

    std::optional<double> initial_temperature() const override
    {
      return law_->initial_temperature();
    }

    FlowStress
    evaluate(const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const override
    {
      return law_->evaluate(slow, flow, start, end);
    }

    double at_rest(const double slow, const double strain, const double *const history) const override
    {
      return law_->at_rest(slow, strain, history);
    }

  protected:
    explicit RateDecorator(std::unique_ptr<RateFactor> law)
      : law_(std::move(law))
    {
    }

    const RateFactor &law() const
    {
      return *law_;
    }

  private:
    std::unique_ptr<RateFactor> law_;
  };
} // namespace deltaform
