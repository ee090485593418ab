#pragma once

#include <deltaform/io/keyed_arrays.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/point_history.h>

#include <cstddef>
#include <vector>

namespace deltaform
{
  /**
   * The predictor of BDF2, the two-step backward differentiation formula, for the flow of all points. w is the length
   * of the increment over that of the last one, h the plastic strain and the equivalent plastic strain, f their rate:
   *
   *     h_n+1 = h* + (1 + w)/(1 + 2 w) dt f_n+1,      h* = h_n + w^2/(1 + 2 w) (h_n - h_n-1).
   *
   * This is backward Euler from the predictor h* instead of h_n: the same return map and the same tangent, of second
   * order and L-stable. The class keeps h_n - h_n-1 and computes h* - h_n. Derivation: doc/theory/materials.md.
   * C.W. Gear, Numerical Initial Value Problems in Ordinary Differential Equations, Prentice-Hall 1971; for plasticity
   * P. Papadopoulos, R.L. Taylor, On the application of multi-step integration methods to infinitesimal
   * elastoplasticity, Int. J. Numer. Meth. Eng. 37 (1994) 3169.
   */
  class Bdf2Predictor
  {
  public:
    /// Largest ratio w; a longer increment is backward Euler. BDF2 is zero-stable for growing increments up to
    /// w = 1 + sqrt(2).
    static constexpr double largest_ratio = 2.;

    Bdf2Predictor() = default;

    Bdf2Predictor(const std::size_t n_points, const unsigned int values_per_point)
      : values_per_point_(values_per_point), last_(n_points * values_per_point, 0.), predictor_(last_)
    {
    }

    bool used() const
    {
      return !last_.empty();
    }

    /// Keep the flow of the increment that ends. Call before @p history is committed.
    void keep(const PointHistory &history)
    {
      const double *before = history.committed(0), *after = history.trial(0);
      for (std::size_t i = 0; i < last_.size(); ++i)
        last_[i] = after[i] - before[i];
    }

    /// Compute the predictor for an increment @p ratio times as long as the last one. @return false: backward Euler
    bool predict(const double ratio)
    {
      active_ = used() && ratio > 0. && ratio <= largest_ratio;
      if (!active_)
        return false;
      const double share = ratio * ratio / (1. + 2. * ratio);
      duration_share_ = (1. + ratio) / (1. + 2. * ratio);
      for (std::size_t i = 0; i < last_.size(); ++i)
        predictor_[i] = share * last_[i];
      return true;
    }

    /// The factor (1 + w)/(1 + 2 w) before dt f: the share of the increment's duration that belongs to flow measured
    /// from h*.
    double duration_share() const
    {
      return active_ ? duration_share_ : 1.;
    }

    /// The next increment does not continue the last one: it is backward Euler.
    void discard()
    {
      active_ = false;
      last_.assign(last_.size(), 0.);
    }

    /// h* - h_n of @p point, followed by those of the points behind it; null for backward Euler.
    const double *at(const std::size_t point) const
    {
      return active_ ? predictor_.data() + point * values_per_point_ : nullptr;
    }
    double *at(const std::size_t point)
    {
      return active_ ? predictor_.data() + point * values_per_point_ : nullptr;
    }

    /// There is no predictor until predict() says so.
    void pause()
    {
      active_ = false;
    }

    /// Every array of the state with its name, for PutInto and TakeFrom; pause() after taking it.
    template <typename Flow, typename Action>
    static void each_array(Flow &flow, const Action &action)
    {
      action("flow of the last increment", flow.last_);
    }

  private:
    unsigned int values_per_point_ = 0;
    bool active_ = false;
    double duration_share_ = 1.;
    std::vector<double> last_, predictor_; ///< h_n - h_n-1 and h* - h_n of all points
  };
} // namespace deltaform
