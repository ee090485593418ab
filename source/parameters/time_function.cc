#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/text.h>
#include <deltaform/parameters/time_function.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace deltaform
{
  struct TimeFunction::Implementation
  {
    virtual ~Implementation() = default;
    virtual double value(double time) const = 0;
    /// Increasing times from @p from to @p to between which the function is expected to be monotone.
    virtual std::vector<double> knots(double from, double to) const = 0;
  };

  struct TimeFunction::FromExpression : TimeFunction::Implementation
  {
    explicit FromExpression(Expression e)
      : expression(std::move(e))
    {
    }

    double value(const double time) const override
    {
      return expression(time);
    }

    std::vector<double> knots(const double from, const double to) const override
    {
      constexpr unsigned int n_intervals = 512;
      std::vector<double> times(n_intervals + 1);
      for (unsigned int i = 0; i <= n_intervals; ++i)
        times[i] = from + (to - from) * i / n_intervals;
      times.back() = to;
      return times;
    }

    Expression expression;
  };

  struct TimeFunction::FromTable : TimeFunction::Implementation
  {
    FromTable(const std::string &text, const Constants &constants)
    {
      if (text.find(';') != std::string::npos)
        throw std::invalid_argument("pairs of a table are separated by commas: '0: 0, 1: 1.2'");
      for (const auto &pair : text::split(text, ','))
      {
        const auto colon = pair.find(':');
        if (colon == std::string::npos)
          throw std::invalid_argument("'" + pair + "' is no pair 'time: value' of a table");
        times.push_back(evaluate_number(pair.substr(0, colon), constants));
        values.push_back(evaluate_number(pair.substr(colon + 1), constants));
        const auto n = times.size();
        if (n > 1 && !(times[n - 1] > times[n - 2]))
          throw std::invalid_argument("the times of the table must increase, but " + text::format(times[n - 1]) +
                                      " follows " + text::format(times[n - 2]));
      }
    }

    double value(const double time) const override
    {
      const auto upper = std::upper_bound(times.begin(), times.end(), time);
      if (upper == times.begin())
        return values.front();
      if (upper == times.end())
        return values.back();
      const auto i = static_cast<std::size_t>(upper - times.begin());
      const double weight = (time - times[i - 1]) / (times[i] - times[i - 1]);
      return (1. - weight) * values[i - 1] + weight * values[i];
    }

    std::vector<double> knots(const double from, const double to) const override
    {
      std::vector<double> result = {from};
      for (const double time : times)
        if (time > from && time < to)
          result.push_back(time);
      result.push_back(to);
      return result;
    }

    bool is_constant() const
    {
      return std::all_of(values.begin(), values.end(), [this](const double v) { return v == values.front(); });
    }

    std::vector<double> times, values;
  };

  TimeFunction::TimeFunction(const double value)
    : text_(text::format(value)), constant_(value)
  {
  }

  TimeFunction::TimeFunction(const std::string &text, const std::map<std::string, double> &constants)
    : text_(text::unquoted(text))
  {
    if (text_.empty())
      throw std::invalid_argument("a number, an expression in t or a table 'time: value, ...' is missing");
    // A colon also belongs to muParser's "condition ? a : b".
    if (text_.find(':') != std::string::npos && text_.find('?') == std::string::npos)
    {
      const auto table = std::make_shared<FromTable>(text_, constants);
      if (table->is_constant())
        constant_ = table->values.front();
      else
        implementation_ = table;
      return;
    }
    const Expression expression(text_, constants);
    if (expression.depends_on_time())
      implementation_ = std::make_shared<FromExpression>(expression);
    else
      constant_ = evaluate_number(text_, constants);
  }

  double TimeFunction::operator()(const double time) const
  {
    return implementation_ == nullptr ? constant_ : implementation_->value(time);
  }

  double TimeFunction::inverse(const double value, const double from, const double to) const
  {
    const auto nowhere = std::numeric_limits<double>::quiet_NaN();
    const auto equal = [](const double difference, const double scale) {
      return std::abs(difference) <= 1e-13 * scale;
    };
    if (implementation_ == nullptr)
      return equal(constant_ - value, std::abs(value)) ? from : nowhere;

    const auto difference = [&](const double time) { return implementation_->value(time) - value; };
    const auto times = implementation_->knots(from, to);
    std::vector<double> differences(times.size());
    double scale = std::abs(value);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      differences[i] = difference(times[i]);
      scale = std::max(scale, std::abs(differences[i]));
    }
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      if (equal(differences[i], scale))
        return times[i];
      if (i + 1 < times.size() && !equal(differences[i + 1], scale) && differences[i] * differences[i + 1] < 0.)
      {
        std::uintmax_t iterations = 100;
        const auto bracket = boost::math::tools::toms748_solve(difference,
                                                               times[i],
                                                               times[i + 1],
                                                               differences[i],
                                                               differences[i + 1],
                                                               boost::math::tools::eps_tolerance<double>(52),
                                                               iterations);
        return .5 * (bracket.first + bracket.second);
      }
    }
    return nowhere;
  }

  bool TimeFunction::is_constant() const
  {
    return implementation_ == nullptr;
  }

  const std::string &TimeFunction::text() const
  {
    return text_;
  }
} // namespace deltaform
