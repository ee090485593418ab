#pragma once

#include <deltaform/materials/hardening.h>
#include <deltaform/materials/history_layout.h>
#include <deltaform/materials/metal_heat.h>

#include <limits>
#include <optional>

namespace deltaform
{
  /// The flow of all of an increment, for what is integrated by a one-step rule from the committed history.
  struct WholeFlow
  {
    const Hardening *slow = nullptr; ///< flow stress at a vanishing rate and the initial temperature
    const double *committed = nullptr; ///< history of the rate factor at the begin of the increment
    double growth = 0.; ///< X, of the equivalent plastic strain (1)
    double mean_rate = 0.; ///< X over the duration (1/time); not a number for an increment without duration
    double mean_rate_by_growth = 0.; ///< d mean_rate/dx (1/time)
    double first_stress = std::numeric_limits<double>::infinity(); ///< equivalent stress at the begin of the increment
    double stiffness = 1.; ///< by which it grows over the equivalent strain (stress)
    double duration = 0.; ///< of the increment (time)

    /// With the mean rate of the part of the increment that flows: the equivalent stress first rises to @p yield, the
    /// flow stress at the begin, with its slope in x.
    WholeFlow since_yield(const FlowStress &yield) const
    {
      WholeFlow result = *this;
      if (yield.value > first_stress)
      {
        result.mean_rate = (growth + (yield.value - first_stress) / stiffness) / duration;
        result.mean_rate_by_growth = (1. + yield.slope / stiffness) / duration;
      }
      return result;
    }
  };


  /// The flow of a point in an increment.
  struct PointFlow
  {
    double strain; ///< equivalent plastic strain at the end
    double growth; ///< x: by how much it grows, from the start of the return map
    double rate; ///< at the end (1/time); not a number for an increment without duration
    double rate_by_growth; ///< d rate/dx (1/time)
    WholeFlow whole = {};
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

    /// Does evaluate() want WholeFlow::first_stress?
    virtual bool knows_first_stress() const
    {
      return false;
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
