#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// @p value at the end of an increment that is @p ratio times as long as the last one, in which it changed by
  /// @p change. The rate of a short increment in which the blank has snapped says nothing about a long one: a tenth of
  /// the value at most.
  inline double foreseen(const double value, const double change, const double ratio)
  {
    const double most = .1 * value;
    return value + std::clamp(ratio * change, -most, most);
  }


  /// Positive values of a blank, such as areas, that an increment has to know for its end before it is solved: they are
  /// foreseen by their rates in the last increment. With those of its begin what depends on them would be late by an
  /// increment.
  class ForeseenValues
  {
  public:
    /// Other values, of another mesh or another blank: nothing is known of their rates.
    void reset(std::vector<double> values)
    {
      change_.assign(values.size(), 0.);
      accepted_ = std::move(values);
      present_ = accepted_;
    }

    /// An increment was accepted.
    void accept(std::vector<double> values)
    {
      for (unsigned int i = 0; i < values.size(); ++i)
        change_[i] = std::isfinite(values[i]) ? values[i] - accepted_[i] : 0.; // an elastic face yields at none
      accepted_ = std::move(values);
      present_ = accepted_;
    }

    /// See Blank::begin_increment(); once a saved state was taken, with a ratio of zero.
    void begin_increment(const double ratio)
    {
      present_.resize(accepted_.size());
      for (unsigned int i = 0; i < present_.size(); ++i)
        present_[i] = foreseen(accepted_[i], change_[i], ratio);
    }

    /// Between increments the accepted ones, in an increment those foreseen.
    const std::vector<double> &values() const
    {
      return present_;
    }

    /// The arrays of the state; @p name: of the values.
    template <typename Values, typename Action>
    static void each_array(Values &&values, const std::string &name, const Action &action)
    {
      action(name, values.accepted_);
      action("change of " + name, values.change_);
    }

  private:
    std::vector<double> accepted_, change_; ///< in the last increment
    std::vector<double> present_;
  };
} // namespace deltaform
