#include <deltaform/increment/line_search.h>
#include <deltaform/increment/newton.h>
#include <deltaform/increment/residual_norm.h>
#include <deltaform/increment/returns.h>
#include <deltaform/increment/scaled_norm.h>
#include <deltaform/increment/stagnation.h>
#include <deltaform/increment/step_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace deltaform
{
  namespace
  {
    // Steps of which less than this share is taken, that far from equilibrium, lead nowhere; after some of them shorter
    // increments do.
    constexpr double creeping = 1e-2, far_from_equilibrium = 1e-2;
    constexpr unsigned int most_creeping_steps = 3;

    // It goes on beyond the maximal number of iterations where it is close to the relaxed tolerance.
    constexpr double close_to_tolerance = 1e2;
    constexpr unsigned int most_iterations_if_close = 2; ///< times the maximal number
    constexpr double round_off_of_steps = 1e-10; ///< of the increment: none is better

    // Iterations in which the residual has to halve: at least, and in percent of the most.
    constexpr unsigned int stagnation_window = 8, stagnation_share = 40;
    // The same where one of the last few steps was damped: they go along what nothing resists first, and |R| says
    // little about that.
    constexpr unsigned int window_within_radius = 20, few = 3;

    // In the first iterations of an increment the start, which extrapolation has pressed into the tools, is put on
    // their surfaces: the set is looked for at any residual.
    constexpr unsigned int first_iterations = 2;

    // A search need not find much in the first iterations.
    constexpr unsigned int lenient_iterations = 3;

    // How often a step that the laws cannot follow is quartered.
    constexpr unsigned int most_returns = 6;

    // Closer to equilibrium than this, factors that will not do are corrected between two iterations.
    constexpr double close_enough_to_correct = .1;

    /// Largest scaled change on the way between two places, of all unknowns or those that count.
    double largest_way(const Vector &from,
                       const Vector &to,
                       const std::vector<double> &scale,
                       const std::vector<bool> *counts = nullptr)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < from.size(); ++i)
        if (counts == nullptr || (*counts)[i])
          largest = std::max(largest, std::abs(to[i] - from[i]) * scale[i]);
      return largest;
    }

    /// Largest scaled change of a step of which @p factor is taken.
    double largest_part(const double factor, const Vector &d, const std::vector<double> &scale)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < d.size(); ++i)
        largest = std::max(largest, factor * std::abs(d[i]) * scale[i]);
      return largest;
    }

    /// d.R over the unknowns that are not prescribed.
    double work(const Vector &d, const Vector &residual, const std::vector<bool> &is_prescribed)
    {
      double work = 0.;
      for (unsigned int i = 0; i < d.size(); ++i)
        if (!is_prescribed[i])
          work += d[i] * residual[i];
      return work;
    }

    /// When a solve is given up.
    Stagnation stagnation(const NewtonSettings &settings)
    {
      const unsigned int least = stagnation_share * settings.max_iterations / 100;
      return {std::max(stagnation_window, least),
              std::max(window_within_radius, least),
              most_iterations_if_close * settings.max_iterations,
              close_to_tolerance * settings.relaxed_tolerance,
              settings.relaxed_tolerance};
    }
  } // namespace


  Newton::Newton(Equations &equations, System &system, const NewtonSettings &settings,
                 const std::vector<double> &scale, const std::vector<double> &size, Timers &timers)
    : equations_(equations), system_(system), settings_(settings), scale_(scale), size_(size),
      smallest_motion_(.01 * equations.typical_length()), timers_(timers)
  {
  }


  /// One solve: where it is, and the steps of an iteration.
  class Newton::Solve
  {
  public:
    Solve(const Newton &newton, Vector &q, const Vector &prescribed, const std::vector<bool> &is_prescribed,
          const Vector &q_committed, const double force_floor)
      : newton_(newton), equations_(newton.equations_), system_(newton.system_), settings_(newton.settings_),
        scale_(newton.scale_), active_set_(newton.equations_.active_set()), q_(q), prescribed_(prescribed),
        is_prescribed_(is_prescribed), q_committed_(q_committed),
        norm_(system_, scale_, newton.size_, is_prescribed, force_floor, settings_.force_tolerance),
        stagnation_(stagnation(settings_)),
        increments_(q.size()), start_(q.size()),
        steps_(equations_, system_, settings_, scale_, is_prescribed, newton.timers_, newton.damps_,
               newton.set_limit_),
        d_(steps_.step())
    {
      Vector way = q_;
      way -= q_committed_;
      foreseen_ = scaled_norm(way, scale_);
      system_.set_prescribed(is_prescribed);
    }

    NewtonResult run()
    {
      if (!assemble())
        return ended(Outcome::inadmissible);
      residual_ = norm_.relative();
      result_.residuals.push_back(residual_);
      for (iteration_ = 0;; ++iteration_)
      {
        // 1. Balanced? Then the corrections have their say; without any this is the end.
        measure_way();
        if (is_balanced())
        {
          if (equations_.correct(q_) == 0)
            return ended(Outcome::converged);
          if (++result_.rounds > settings_.max_rounds)
            return ended(Outcome::not_corrected);
          if (!begin_round())
            return ended(Outcome::inadmissible);
        }
        // 2. Is there no hope left?
        if (is_hopeless())
          return ended(Outcome::diverged);
        // 3. The step: linear solve.
        if (!find_step())
          return without_step();
        // 4. As far as it is admissible. Perhaps another one in its place.
        if (!take_step())
          return ended(Outcome::inadmissible);
        double residual = norm_.relative();
        if (residual > residual_ && pending_ == 0. && !replace_step(residual))
          return without_step();
        // 5. Shorter where it leads to a larger residual.
        if (wants_search(residual))
        {
          search();
          residual = norm_.relative();
        }
        // 6. Close to equilibrium, with penalty factors that keep the promise.
        if (!correct_early(residual))
          return ended(Outcome::inadmissible);
        judge_step();
        finish_iteration(residual);
        // 7. Steps that are all but taken back far from equilibrium are given up early.
        if (creeps())
          return ended(Outcome::diverged);
      }
    }

  private:
    using Outcome = NewtonResult::Outcome;

    NewtonResult ended(const Outcome outcome)
    {
      result_.outcome = outcome;
      result_.worst_dof = norm_.worst_dof();
      if (outcome == Outcome::diverged && residual_ <= settings_.relaxed_tolerance)
        result_.imbalance = equations_.imbalance();
      return std::move(result_);
    }

    /// The linear solver found none, or the laws do not follow it.
    NewtonResult without_step()
    {
      if (result_.status.good())
        result_.status = steps_.status();
      return ended(result_.status.good() ? Outcome::singular : Outcome::inadmissible);
    }

    bool assemble()
    {
      result_.status = equations_.assemble(q_, true);
      return result_.status.good();
    }

    /// The same tangent of the blank, contact as it is now.
    bool assemble_again()
    {
      return equations_.assemble_foreseen(q_) || assemble();
    }

    /// How far prescribed unknowns still have to go, and how far the increment has moved the others.
    void measure_way()
    {
      pending_ = largest_way(q_, prescribed_, scale_, &is_prescribed_);
      travelled_ = std::max(newton_.smallest_motion_, largest_way(q_committed_, q_, scale_));
    }

    bool is_balanced()
    {
      const bool late = iteration_ >= settings_.max_iterations && n_undamped_ > 0;
      // The edge of a lightly loaded contact zone may travel node by node for ever: after many iterations less will do,
      // but the forces that are reported have to balance.
      const double tolerance = late ? settings_.relaxed_tolerance : settings_.force_tolerance;
      const bool fresh = iteration_ == 0 && result_.rounds == 0; // forces of the extrapolated start
      if (fresh || pending_ != 0. || !(residual_ <= tolerance) ||
          (active_set_ != nullptr && !active_set_->consistent(tolerance * norm_.magnitude())) ||
          (last_step_ > round_off_of_steps * travelled_ && equations_.imbalance() > settings_.balance_tolerance))
        return returns_.leave();
      // A damped step is no measure of the error.
      if (n_undamped_ == 0)
        steps_.damping().loosen();
      const bool moved =
        n_undamped_ > 0 && (last_step_ <= settings_.displacement_tolerance * travelled_ || last_step_ <= 1e-14);
      return moved || residual_ <= 1e-3 * tolerance || late ||
             returns_.come(q_, scale_, settings_.displacement_tolerance * travelled_);
    }

    bool begin_round()
    {
      iteration_ = 0;
      returns_ = Returns();
      result_.residuals.clear();
      if (!assemble())
        return false;
      residual_ = norm_.relative();
      return true;
    }

    bool is_hopeless() const
    {
      if (!std::isfinite(residual_) || (pending_ == 0. && stagnation_.reached(result_.residuals, n_undamped_ < few)))
        return true;
      return iteration_ >= settings_.max_iterations &&
             (residual_ >= stagnation_.near || iteration_ >= stagnation_.most_iterations);
    }

    bool find_step()
    {
      for (unsigned int i = 0; i < q_.size(); ++i)
        increments_[i] = is_prescribed_[i] ? prescribed_[i] - q_[i] : 0.;
      ++result_.iterations;
      result_.correction_iterations += result_.rounds > 0;
      return steps_.find(start_of_step(), increments_);
    }

    StepSearch::Start start_of_step() const
    {
      return {q_, residual_, norm_.magnitude(), pending_ != 0., result_.rounds == 0 && iteration_ < first_iterations};
    }

    /// To the start of the step plus a share of it.
    bool go(const double factor)
    {
      for (unsigned int i = 0; i < q_.size(); ++i)
        q_[i] = factor == 1. && is_prescribed_[i] ? prescribed_[i] : start_[i] + factor * d_[i];
      if (active_set_ != nullptr)
        active_set_->advance(factor);
      return assemble();
    }

    bool take_step()
    {
      if (active_set_ != nullptr)
        active_set_->prepare_step(d_);
      factor_ = equations_.limit_step(q_, d_);
      start_ = q_;
      work_start_ = work(d_, system_.residual(), is_prescribed_);
      // Go back until the laws can be evaluated.
      bool good = go(factor_);
      for (unsigned int back = 0; !good && back < most_returns; ++back)
      {
        factor_ *= .25;
        ++result_.line_searches;
        good = go(factor_);
      }
      return good;
    }

    /// The step has led to a larger residual. If its set was a guess: that of the first set. If it was long against
    /// what was foreseen of the increment: one within a radius. But a balanced state may be left.
    bool replace_step(double &residual)
    {
      if (steps_.is_guess() && !step_again(&StepSearch::find_without_set, residual))
        return false;
      const bool again = residual > residual_ && newton_.damps_ && residual_ > settings_.force_tolerance &&
                         steps_.damping().bound(residual_, steps_.length(), foreseen_);
      return !again || step_again(&StepSearch::find_again, residual);
    }

    /// From the same start, as @p find finds it.
    bool step_again(bool (StepSearch::*const find)(const StepSearch::Start &), double &residual)
    {
      if (!go(0.))
        return false;
      norm_.relative(); // the magnitude at the start
      const bool made = (steps_.*find)(start_of_step()) && take_step();
      residual = norm_.relative();
      return made;
    }

    bool wants_search(const double residual) const
    {
      return settings_.line_search && pending_ == 0. && residual > residual_ &&
             (active_set_ == nullptr || !active_set_->changed() || iteration_ >= active_set_->patience());
    }

    void search()
    {
      // Another radius is cheaper than more assemblies along a step.
      const double share = steps_.is_bound(start_of_step()) ? .9 : (iteration_ < lenient_iterations ? .8 : .2);
      LineSearch search;
      const auto work_here = [this] { return work(d_, system_.residual(), is_prescribed_); };
      factor_ = search.search(factor_, work_start_, work_here(), share, [&](const double factor) {
        return go(factor) ? std::optional<double>(work_here()) : std::nullopt;
      });
      result_.line_searches += search.n_evaluations();
    }

    /// Corrections that need not wait for convergence converge with the unknowns; rounds of their own would cost two
    /// iterations each.
    bool correct_early(double &residual)
    {
      const bool is_time = settings_.max_rounds > 0 && pending_ == 0. && residual <= close_enough_to_correct &&
                           residual > settings_.force_tolerance;
      if (!is_time || equations_.correct_early() == 0)
        return true;
      if (!assemble_again())
        return false;
      residual = norm_.relative();
      return true;
    }

    void judge_step()
    {
      if (pending_ != 0.)
        return;
      n_undamped_ = steps_.is_damped() ? 0 : n_undamped_ + 1;
      steps_.damping().judge(residual_, factor_, steps_.length());
    }

    void finish_iteration(const double residual)
    {
      residual_ = residual;
      last_step_ = largest_part(factor_, d_, scale_);
      result_.residuals.push_back(residual_);
    }

    bool creeps()
    {
      return residual_ > far_from_equilibrium && factor_ < creeping &&
             ++n_creeping_ == most_creeping_steps;
    }

    const Newton &newton_;
    Equations &equations_;
    System &system_;
    const NewtonSettings &settings_;
    const std::vector<double> &scale_;
    ActiveSet *active_set_;
    Vector &q_;
    const Vector &prescribed_;
    const std::vector<bool> &is_prescribed_;
    const Vector &q_committed_;
    ResidualNorm norm_;

    NewtonResult result_;
    const Stagnation stagnation_;
    Vector increments_, start_; ///< of prescribed unknowns; where the step starts
    StepSearch steps_;
    Vector &d_; ///< the step
    Returns returns_;
    unsigned int iteration_ = 0, n_creeping_ = 0;
    unsigned int n_undamped_ = few; ///< steps in a row
    double residual_ = 0., foreseen_ = 0.; ///< relative; way of the increment to where the solve starts, scaled
    double pending_ = 0., travelled_ = 0.;
    double factor_ = 1., work_start_ = 0.; ///< of the step that is taken, and of the residual along it at its start
    double last_step_ = std::numeric_limits<double>::infinity();
  };


  NewtonResult Newton::solve(Vector &q, const Vector &prescribed, const std::vector<bool> &is_prescribed,
                             const Vector &q_committed, const double force_floor)
  {
    return Solve(*this, q, prescribed, is_prescribed, q_committed, force_floor).run();
  }
} // namespace deltaform
