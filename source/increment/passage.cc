#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/increment/passage.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace deltaform
{
  namespace
  {
    constexpr std::size_t most_states = 33; ///< an element that passes in more increments needs no other guess
    constexpr std::size_t window = 3; ///< increments that are compared

    /// Index of the first time of an interval, and the share of it that has passed.
    std::pair<std::size_t, double> place_in(const std::vector<double> &times, const double time)
    {
      const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
      const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
      return {k, (time - times[k]) / (times[k + 1] - times[k])};
    }
  } // namespace


  /// Bends of all elements in all states that are known.
  class Passage::Bends
  {
  public:
    Bends(const std::vector<double> &times, const std::vector<Vector> &states, const ElementChain &chain)
      : times_(times), n_(chain.rotations.size() - 1), bends_(states.size() * n_)
    {
      for (std::size_t k = 0; k < states.size(); ++k)
        for (std::size_t i = 0; i < n_; ++i)
          bends_[k * n_ + i] = states[k][chain.rotations[i + 1]] - states[k][chain.rotations[i]];
    }

    /// By how much every element has bent in the window that ended a @p lag ago; empty if that is not known.
    std::vector<double> change(const double lag) const
    {
      const double end = times_.back() - lag, begin = begin_ - lag;
      if (begin < times_.front())
        return {};
      std::vector<double> result(n_, 0.);
      add(end, 1., result);
      add(begin, -1., result);
      return result;
    }

    /// By how much an element has bent over a @p lag, at most.
    double largest_change(const double lag) const
    {
      std::vector<double> result(n_, 0.);
      add(times_.back(), 1., result);
      add(times_.back() - lag, -1., result);
      return std::abs(*std::max_element(result.begin(),
                                        result.end(),
                                        [](const double a, const double b) { return std::abs(a) < std::abs(b); }));
    }

    /// Sum of the squares by which @p now differs from what the neighbours did a @p lag before.
    double mismatch(const std::vector<double> &now, const double lag, const bool towards_end) const
    {
      const std::vector<double> then = change(lag);
      if (then.empty())
        return std::numeric_limits<double>::infinity();
      double sum = 0.;
      for (std::size_t i = 0; i + 1 < n_; ++i)
      {
        const double e = towards_end ? now[i] - then[i + 1] : now[i + 1] - then[i];
        sum += e * e;
      }
      return sum;
    }

  private:
    void add(const double time, const double factor, std::vector<double> &result) const
    {
      const auto [k, share] = place_in(times_, time);
      const double *const first = &bends_[k * n_], *const second = first + n_;
      for (std::size_t i = 0; i < n_; ++i)
        result[i] += factor * ((1. - share) * first[i] + share * second[i]);
    }

    const std::vector<double> &times_;
    std::size_t n_; ///< elements
    std::vector<double> bends_; ///< by states and elements (rad)
    double begin_ = times_[times_.size() - 1 - std::min(window, times_.size() - 1)];
  };


  void Passage::accept(const Vector &before,
                       const Vector &now,
                       const Vector &expected,
                       const double length,
                       const StiffnessView &tangent,
                       const ElementChain &chain)
  {
    constexpr double memory = .9, most = 2.; // of an increment; a snap is no passage
    if (chain.empty())
      return;
    if (auto guess = of_neighbours(length, chain))
    {
      *guess -= expected;
      Vector missed = now;
      missed -= before;
      missed -= expected;
      Vector force(guess->size());
      tangent.multiply(*guess, force);
      const double energy = *guess * force;
      if (energy > 0.)
      {
        found_ = memory * found_ + std::clamp(missed * force, -most * energy, most * energy);
        looked_for_ = memory * looked_for_ + energy;
      }
    }
    remember(before, now, length);
    find_lag(Bends(times_, states_, chain));
  }


  void Passage::remember(const Vector &before, const Vector &now, const double length)
  {
    if (states_.empty())
    {
      times_.push_back(0.);
      states_.push_back(before);
    }
    times_.push_back(times_.back() + length);
    states_.push_back(now);
    if (states_.size() > most_states)
    {
      times_.erase(times_.begin());
      std::rotate(states_.begin(), states_.begin() + 1, states_.end());
      states_.pop_back();
    }
  }


  void Passage::find_lag(const Bends &bends)
  {
    constexpr unsigned int sections = 10;
    const double golden = .5 * (3. - std::sqrt(5.)), last = times_.back() - times_[times_.size() - 2];
    const std::vector<double> now = bends.change(0.);
    double best = std::numeric_limits<double>::infinity();
    const auto look = [&](const double lag, const bool towards_end) {
      const double found = bends.mismatch(now, lag, towards_end);
      if (found < best)
      {
        best = found;
        lag_ = lag;
        towards_end_ = towards_end;
      }
      return found;
    };
    lag_ = 0.;
    for (const bool towards_end : {false, true})
      for (std::size_t k = 0; k + 1 < times_.size(); ++k)
        look(times_.back() - times_[k], towards_end);
    double low = std::max(lag_ - last, .3 * last), high = lag_ + last;
    for (unsigned int i = 0; i < sections && lag_ > 0.; ++i)
    {
      const double a = low + golden * (high - low), b = high - golden * (high - low);
      if (look(a, towards_end_) < look(b, towards_end_))
        high = b;
      else
        low = a;
    }
    const double size = std::inner_product(now.begin(), now.end(), now.begin(), 0.);
    mismatch_ = size > 0. && best < size ? best / size : 1.;
    turned_ = bends.largest_change(lag_);
  }


  double Passage::weight() const
  {
    // Half of it is no passage: what is left of it costs more iterations than it saves.
    constexpr double least = .5, gate = 5.;
    if (!(looked_for_ > 0.))
      return 0.;
    const double w = std::clamp(found_ / looked_for_, 0., 1.) * std::max(1. - gate * mismatch_, 0.);
    return w > least ? w : 0.;
  }


  std::optional<Vector> Passage::of_neighbours(const double length, const ElementChain &chain) const
  {
    if (!(lag_ >= length))
      return std::nullopt;
    Vector move = state(times_.back() - lag_ + length);
    move -= state(times_.back() - lag_);
    Vector result = move;
    const std::vector<DofIndex> &neighbour = towards_end_ ? chain.ahead : chain.behind;
    for (std::size_t i = 0; i < neighbour.size(); ++i)
      result[i] = move[neighbour[i]];
    return result;
  }


  std::optional<Vector> Passage::step(const Vector &expected, const double length, const ElementChain &chain) const
  {
    const double w = chain.empty() ? 0. : weight();
    if (!(w > 0.))
      return std::nullopt;
    auto result = of_neighbours(length, chain);
    if (result)
      result->sadd(w, 1. - w, expected);
    return result;
  }


  double Passage::longest() const
  {
    // The work of bending is integrated over so many increments; finer ones say the same within half a percent.
    constexpr double bend = 1.9 / 180. * dealii::numbers::PI;
    constexpr double any = std::numeric_limits<double>::infinity();
    if (!(weight() > 0.))
      return any;
    const double last = times_.back() - times_[times_.size() - 2];
    if (!(lag_ > last))
      return any;
    return std::max(last, lag_ / std::max(std::ceil(turned_ / bend), 1.));
  }


  Vector Passage::state(const double time) const
  {
    const auto [k, share] = place_in(times_, time);
    Vector result = states_[k];
    result.sadd(1. - share, share, states_[k + 1]);
    return result;
  }


  bool Passage::fits(const std::size_t n_unknowns) const
  {
    const auto finite = [](const double x) { return std::isfinite(x); };
    return times_.size() == states_.size() && states_.size() != 1 && states_.size() <= most_states &&
           std::all_of(times_.begin(), times_.end(), finite) &&
           std::adjacent_find(times_.begin(), times_.end(), std::greater_equal<>()) == times_.end() &&
           std::all_of(states_.begin(), states_.end(), [&](const Vector &q) { return q.size() == n_unknowns; }) &&
           finite(found_) && finite(looked_for_) && finite(mismatch_) && finite(turned_) && lag_ >= 0. &&
           (states_.empty() ? lag_ == 0. : lag_ <= times_.back() - times_.front());
  }
} // namespace deltaform
