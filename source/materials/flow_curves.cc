#include <deltaform/materials/flow_curves.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// The rows of one rate and temperature.
    struct Group
    {
      double rate, temperature;
      std::vector<std::vector<double>> points; ///< strain, stress

      std::string name() const
      {
        return "at rate " + text::format(rate) + ", temperature " + text::format(temperature) + ": ";
      }

      std::optional<FlowCurve> curve() const
      {
        if (std::all_of(points.begin(), points.end(), [](const auto &point) { return point[1] == 0.; }))
          return std::nullopt;
        try
        {
          return FlowCurve(points);
        }
        catch (const std::invalid_argument &error)
        {
          throw std::invalid_argument(name() + error.what());
        }
      }
    };

    std::vector<Group> grouped(const std::vector<std::vector<double>> &rows)
    {
      std::vector<Group> result;
      for (const auto &row : rows)
      {
        const Group here{row[0], row[1], {}};
        if (!(here.rate > 0.))
          throw std::invalid_argument(here.name() + "the rate is not positive.");
        const auto order = [](const Group &group) { return std::pair(group.rate, group.temperature); };
        if (!result.empty() && order(here) < order(result.back()))
          throw std::invalid_argument(here.name() + "the rows are not sorted by rate, then by temperature.");
        if (result.empty() || order(result.back()) < order(here))
          result.push_back(here);
        result.back().points.push_back({row[2], row[3]});
      }
      if (result.empty())
        throw std::invalid_argument("there are no rows.");
      return result;
    }
  } // namespace


  FlowCurves::FlowCurves(const std::vector<std::vector<double>> &rows)
  {
    const auto groups = grouped(rows);
    for (const Group &group : groups)
    {
      if (rates_.empty() || group.rate > rates_.back())
        rates_.push_back(group.rate);
      if (rates_.size() == 1)
        temperatures_.push_back(group.temperature);
    }
    const std::size_t n = temperatures_.size();
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (i >= rates_.size() * n || groups[i].rate != rates_[i / n] || groups[i].temperature != temperatures_[i % n])
        throw std::invalid_argument(groups[i].name() + "the rates do not have curves at the same temperatures.");
    if (groups.size() < rates_.size() * n)
      throw std::invalid_argument(groups.back().name() + "a curve is missing: each rate needs all temperatures.");

    for (const double rate : rates_)
      log_rates_.push_back(std::log(rate));
    for (const Group &group : groups)
      curves_.push_back(group.curve());
    std::vector<double> strains;
    for (const auto &row : rows)
      strains.push_back(row[2]);
    std::sort(strains.begin(), strains.end());
    check_order(strains);
  }


  void FlowCurves::check_order(const std::vector<double> &strains) const
  {
    // Monotone cubics may cross between the rows, too: looked at in steps of a sixteenth.
    constexpr unsigned int n_steps = 16;
    const auto check = [&](const std::size_t low, const std::size_t high, const std::string &sentence) {
      for (std::size_t i = 0; i + 1 < strains.size(); ++i)
        for (unsigned int k = 0; k <= n_steps; ++k)
        {
          const double e = strains[i] + k * (strains[i + 1] - strains[i]) / n_steps;
          const double below = curve(low, e).value, above = curve(high, e).value;
          if (below > above * (1. + 1e-12))
            throw std::invalid_argument("at strain " + text::rounded(e) + " " + sentence);
        }
    };
    const std::size_t n = temperatures_.size();
    for (std::size_t i = 0; i < curves_.size(); ++i)
    {
      if (i + n < curves_.size())
        check(i, i + n,
              "and temperature " + text::format(temperatures_[i % n]) + " the flow stress falls with the rate.");
      if (i % n + 1 < n)
        check(i + 1, i, "and rate " + text::format(rates_[i / n]) + " the flow stress rises with the temperature.");
    }
  }


  FlowCurves::Place FlowCurves::place_of(const double x, const std::vector<double> &sorted)
  {
    if (!(x > sorted.front()))
      return {0, 0., 0.};
    if (x >= sorted.back())
      return {sorted.size() - 1, 0., 0.};
    const std::size_t i = std::upper_bound(sorted.begin(), sorted.end(), x) - sorted.begin() - 1;
    const double length = sorted[i + 1] - sorted[i];
    return {i, (x - sorted[i]) / length, 1. / length};
  }


  FlowStress FlowCurves::curve(const std::size_t i, const double strain) const
  {
    return curves_[i] ? (*curves_[i])(strain) : FlowStress{0., 0.};
  }


  FlowCurves::Stress FlowCurves::operator()(const double strain, const double rate, const double temperature) const
  {
    const Place r = place_of(rate > 0. ? std::log(rate) : -std::numeric_limits<double>::infinity(), log_rates_);
    const Place t = place_of(temperature, temperatures_);
    const std::size_t n = temperatures_.size();
    Stress sum{0., 0., 0., 0.};
    for (const bool faster : {false, true})
      for (const bool hotter : {false, true})
      {
        if ((faster && r.slope == 0.) || (hotter && t.slope == 0.))
          continue;
        const FlowStress part = curve((r.i + (faster ? 1 : 0)) * n + t.i + (hotter ? 1 : 0), strain);
        const double by_rate = faster ? r.share : 1. - r.share, by_temperature = hotter ? t.share : 1. - t.share;
        sum.value += by_rate * by_temperature * part.value;
        sum.by_strain += by_rate * by_temperature * part.slope;
        sum.by_rate += (faster ? 1. : -1.) * r.slope * by_temperature * part.value;
        sum.by_temperature += (hotter ? 1. : -1.) * t.slope * by_rate * part.value;
      }
    sum.by_rate = r.slope > 0. ? sum.by_rate / rate : 0.;
    return sum;
  }
} // namespace deltaform
