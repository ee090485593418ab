#pragma once

#include "heat_balance.h"
#include "rate_decorator.h"

#include <deltaform/materials/softening.h>

#include <array>
#include <memory>

namespace deltaform
{
  /**
   * A rate factor with the heat of the flow, which stays where it is made (adiabatic) over the increment:
   *
   *     dT = (share/(rho c)) s dx,   s = f(T - T0) s_cold,
   *
   * rho c the heat capacity of the volume before deformation, s a Kirchhoff stress, s_cold that of the other laws, f
   * the softening. The work of the increment is integrated along its growth of the plastic strain at the mean rate,
   * from its begin (balance_heat): the increment in which flow begins heats as exactly as the others. One equation
   * in T is left, which is solved in evaluate(). W.S. Farren, G.I. Taylor, The heat developed during plastic
   * extension of metals, Proc. R. Soc. A 107 (1925) 422.
   */
  class AdiabaticHeat final : public RateDecorator
  {
  public:
    /// @p heating share/(rho c) (temperature/stress)
    /// @p conducts nothing: the heat stays there between increments as well; if not, it may be cooled below its start
    AdiabaticHeat(std::unique_ptr<RateFactor> cold,
                  std::unique_ptr<Softening> softening,
                  double heating,
                  const std::optional<MetalHeat> &conducts = std::nullopt);

    HistoryLayout history_layout() const override;
    bool needs_duration() const override;
    bool knows_first_stress() const override;
    bool softens() const override;
    std::optional<MetalHeat> heat() const override;
    FlowStress
    evaluate(const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const override;
    double at_rest(double slow, double strain, const double *history) const override;

  private:
    /// The rise of the temperature in @p history.
    double rise(const double *history) const;

    /// Without heat, at the mean rate, with slopes in the growth.
    std::array<FlowStress, HeatStages::n>
    cold_stages(const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const;

    std::unique_ptr<Softening> softening_;
    double heating_;
    std::optional<MetalHeat> conducts_;
    unsigned int rise_; ///< its place in the history, after that of the rate factor
  };
} // namespace deltaform
