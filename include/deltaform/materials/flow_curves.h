#pragma once

#include <deltaform/materials/hardening_laws.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /**
   * Measured flow curves over rate and temperature: rows (rate, temperature, strain, stress), sorted by the first three
   * in this order. The rows of one rate and temperature are a curve, a FlowCurve: monotone cubic in the strain,
   * constant beyond its last row. Every rate has curves at the same temperatures. Between curves the stress is linear
   * in the logarithm of the rate and linear in the temperature; outside of the rates and temperatures of the table it
   * is that of the nearest ones: what was not measured is not invented. The stress may not fall with the strain or the
   * rate, nor rise with the temperature. A curve of stress zero, one row will do, is molten metal.
   *
   * Rates (1/time) > 0, temperatures on any scale, logarithmic plastic strains, Kirchhoff stresses.
   */
  class FlowCurves
  {
  public:
    struct Stress
    {
      double value;
      double by_strain, by_rate, by_temperature; ///< derivatives; one-sided where curves meet
    };

    /// @throws std::invalid_argument if the rows are not like that
    explicit FlowCurves(const std::vector<std::vector<double>> &rows);

    Stress operator()(double strain, double rate, double temperature) const;

    bool knows_rate() const
    {
      return rates_.size() > 1;
    }

  private:
    /// Where a value lies in a sorted list: share of the way from entry i to entry i + 1.
    struct Place
    {
      std::size_t i;
      double share;
      double slope; ///< d share/d value; 0: outside of the list, where the entry i holds
    };

    static Place place_of(double x, const std::vector<double> &sorted);

    FlowStress curve(std::size_t i, double strain) const;

    /// @param strains of all rows, sorted
    /// @throws std::invalid_argument if the stress falls with the rate or rises with the temperature
    void check_order(const std::vector<double> &strains) const;

    std::vector<double> rates_, log_rates_, temperatures_;
    std::vector<std::optional<FlowCurve>> curves_; ///< rate by rate; none: molten
  };

} // namespace deltaform
