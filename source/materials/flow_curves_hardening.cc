#include <deltaform/io/point_file.h>
#include <deltaform/materials/flow_curves.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include "heat_balance.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// What flow curves make of rate and temperature. Where heat is counted, that of an increment is the heat of its
    /// flow.
    class FlowCurvesFactor final : public RateFactor
    {
    public:
      FlowCurvesFactor(FlowCurves curves, const double initial_temperature, const double heating)
        : curves_(std::move(curves)), initial_temperature_(initial_temperature), heating_(heating)
      {
      }

      HistoryLayout history_layout() const override
      {
        return heating_ > 0. ? HistoryLayout{{"temperature_rise", HistoryKind::positive, "temperature"}}
                             : HistoryLayout();
      }

      bool acts() const override
      {
        return curves_.knows_rate() || heating_ > 0.;
      }

      bool needs_duration() const override
      {
        return curves_.knows_rate();
      }

      bool knows_first_stress() const override
      {
        return heating_ > 0. && curves_.knows_rate();
      }

      bool softens() const override
      {
        return heating_ > 0.;
      }

      std::optional<double> initial_temperature() const override
      {
        return initial_temperature_;
      }

      FlowStress
      evaluate(const FlowStress &, const PointFlow &flow, const double *, double *end) const override
      {
        const double rate = curves_.knows_rate() ? flow.rate : 0.;
        const double rate_by_growth = curves_.knows_rate() ? flow.rate_by_growth : 0.;
        const HeatedEnd heated = heating_ > 0. ? heat_up(flow) : HeatedEnd{0., 0.};
        if (heating_ > 0.)
          *end = heated.rise;
        const FlowCurves::Stress at = curves_(flow.strain, rate, initial_temperature_ + heated.rise);
        return {at.value, at.by_strain + rate_by_growth * at.by_rate + at.by_temperature * heated.by_growth};
      }

      double at_rest(double, const double strain, const double *const history) const override
      {
        return curves_(strain, 0., initial_temperature_ + (heating_ > 0. ? *history : 0.)).value;
      }

    private:
      WholeFlow since_yield(const PointFlow &flow) const
      {
        WholeFlow result = flow.whole;
        if (!std::isfinite(result.first_stress))
          return result;
        const double temperature = initial_temperature_ + *result.committed;
        for (unsigned int repeated = 0; repeated < HeatStages::rate_corrections; ++repeated)
        {
          const FlowCurves::Stress at = curves_(flow.strain - result.growth, result.mean_rate, temperature);
          result = flow.whole.since_yield({at.value, at.by_rate * result.mean_rate_by_growth});
        }
        return result;
      }

      /// From the committed rise of the temperature, at the mean rate.
      HeatedEnd heat_up(const PointFlow &flow) const
      {
        const WholeFlow whole = since_yield(flow);
        const double rate = curves_.knows_rate() ? whole.mean_rate : 0.;
        const double rate_by_growth = curves_.knows_rate() ? whole.mean_rate_by_growth : 0.;
        const auto hot = [&](const unsigned int stage, const double rise) -> HotStress {
          const double c = HeatStages::place[stage];
          const FlowCurves::Stress at =
            curves_(flow.strain - (1. - c) * whole.growth, rate, initial_temperature_ + rise);
          return {at.value, c * at.by_strain + rate_by_growth * at.by_rate, at.by_temperature};
        };
        std::array<FlowStress, HeatStages::n> cold;
        for (unsigned int i = 0; i < HeatStages::n; ++i)
        {
          const HotStress at = hot(i, *whole.committed);
          cold[i] = {at.value, at.by_growth};
        }
        return balance_heat(cold, hot, *whole.committed, heating_, whole.growth);
      }

      FlowCurves curves_;
      double initial_temperature_, heating_;
    };


    /// Flow curves as a hardening law. It knows rate and temperature itself; by itself it is that of a vanishing rate.
    class FlowCurvesHardening final : public Hardening
    {
    public:
      /// @param initial_temperature of the metal, on the scale of the curves
      /// @throws std::invalid_argument if the metal is molten there
      FlowCurvesHardening(FlowCurves curves, const double initial_temperature)
        : curves_(std::move(curves)), initial_temperature_(initial_temperature)
      {
        if (!(FlowCurvesHardening::evaluate(0.).value > 0.))
          throw std::invalid_argument("the metal would be molten from the start.");
      }

      FlowStress evaluate(const double equivalent_plastic_strain) const override
      {
        const FlowCurves::Stress at = curves_(equivalent_plastic_strain, 0., initial_temperature_);
        return {at.value, at.by_strain};
      }

      std::unique_ptr<RateFactor> own_rate_factor(const double heating) const override
      {
        return std::make_unique<FlowCurvesFactor>(curves_, initial_temperature_, heating);
      }

    private:
      FlowCurves curves_;
      double initial_temperature_;
    };


    constexpr const char *rows_entry = "Flow curves", *file_entry = "File";

    /// From the entry or from a file. @return the entry that has said them, and the rows
    std::pair<std::string, std::vector<std::vector<double>>> read_curves(Section &section)
    {
      const std::string file =
        section.text(file_entry,
                     Default<std::string>(""),
                     "File with the rows of Flow curves in their place, one a line; commas or blanks separate, # "
                     "begins a comment, a first line may name the columns. Its path starts from the folder in which "
                     "the program runs.");
      const std::string example =
        "0.001 20 0 200; 0.001 20 0.1 339; 0.001 20 0.3 400; 0.001 20 1 489; "
        "0.001 300 0 120; 0.001 300 0.1 170; 0.001 300 0.3 190; 0.001 300 1 200; "
        "10 20 0 240; 10 20 0.1 350; 10 20 0.3 420; 10 20 1 500; "
        "10 300 0 170; 10 300 0.1 230; 10 300 0.3 250; 10 300 1 260";
      auto rows = section.rows(
        rows_entry,
        file.empty() ? required(example) : Default<std::string>(""),
        4,
        "1/time, temperature, 1, stress",
        "Rows of rate, temperature, plastic strain and flow stress, sorted in this order; four or more of each rate "
        "and temperature. Linear in log rate and in temperature; outside as at the nearest rate, temperature and "
        "strain. Stress 0 is molten metal. Not used with File.");
      if (file.empty())
        return {rows_entry, rows};
      if (!rows.empty())
        section.fail(file_entry, "give the curves in a File or as Flow curves, not both.");
      try
      {
        rows = read_rows(file, 4);
      }
      catch (const std::invalid_argument &error)
      {
        section.fail(file_entry, "'" + file + "': " + error.what() + ".");
      }
      return {file_entry, rows};
    }


    std::unique_ptr<Hardening> read(Section &section)
    {
      const std::string start_entry = "Initial temperature";
      const auto [entry, rows] = read_curves(section);
      const double start = section.number(
        start_entry, required(20.), Range::any(), "temperature", "Of the metal, on the scale of the curves.");
      try
      {
        FlowCurves curves(rows);
        try
        {
          return std::make_unique<FlowCurvesHardening>(std::move(curves), start);
        }
        catch (const std::invalid_argument &error)
        {
          section.fail(start_entry, error.what());
        }
      }
      catch (const std::invalid_argument &error)
      {
        section.fail(entry, error.what());
      }
    }

    const Registry<Hardening>::Entry entry("flow curves", "Curves over strain, rate and temperature", read);
  } // namespace
} // namespace deltaform
