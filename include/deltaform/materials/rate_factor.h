#pragma once

#include <deltaform/materials/hardening.h>
#include <deltaform/materials/history_layout.h>
#include <deltaform/materials/metal_heat.h>

#include <optional>

namespace deltaform
{
  /// The flow of a point in an increment.
  struct PointFlow
  {
    double strain; ///< equivalent plastic strain at the end
    double growth; ///< x: by how much it grows
    double rate; ///< at the end (1/time); not a number for an increment without duration
    double rate_by_growth; ///< d rate/dx (1/time)
  };

  /**
   * What the rate of flow and the temperature make of the flow stress. A law that heats the metal by its own flow
   * (adiabatic) keeps the rise of temperature in its own field of the history and solves for it within evaluate().
   */
  class RateFactor
  {
  public:
    virtual ~RateFactor() = default;

    /// Fields of its own, behind those of the backstress; @p start and @p end below point to them. They start at zero.
    virtual HistoryLayout history_layout() const = 0;

    /// false: the flow stress knows neither rate nor temperature.
    virtual bool acts() const
    {
      return true;
    }

    /// Does evaluate() want the duration of the increment?
    virtual bool needs_duration() const
    {
      return true;
    }

    /// Can the flow stress fall below its value at zero plastic strain?
    virtual bool softens() const
    {
      return false;
    }

    /// Nothing: heat stays where it is made, or is not counted.
    virtual std::optional<MetalHeat> heat() const
    {
      return std::nullopt;
    }

    /// Temperature of the metal at its start, of a law whose curves are over the temperature itself; nothing: it knows
    /// the rise only.
    virtual std::optional<double> initial_temperature() const
    {
      return std::nullopt;
    }

    /**
     * @param slow flow stress at a vanishing rate and the initial temperature, and its slope, after @p flow
     * @return flow stress and its slope in the growth x; must not fall under @p slow at x = 0 by more than heat
     *   softens. Writes the history at the end.
     */
    virtual FlowStress
    evaluate(const FlowStress &slow, const PointFlow &flow, const double *start, double *end) const = 0;

    /// Flow stress of a point at rest, at a vanishing rate and the temperature of its @p history, after the equivalent
    /// plastic @p strain.
    virtual double at_rest(const double slow, const double /*strain*/, const double * /*history*/) const
    {
      return slow;
    }
  };
} // namespace deltaform
