#include <deltaform/increment/line_search.h>
#include <deltaform/increment/newton.h>
#include <deltaform/increment/residual_norm.h>
#include <deltaform/increment/returns.h>
#include <deltaform/increment/set_search.h>
#include <deltaform/increment/stagnation.h>
#include <deltaform/increment/step_damping.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

    // Iterations in which the residual has to halve: at least, and in percent of the most.
    constexpr unsigned int stagnation_window = 8, stagnation_share = 40;

    // As close to equilibrium the tangent of the blank is good for all sets that the solve may meet; so they are tried
    // with it. In the first iterations of an increment the start, which extrapolation has pressed into the tools, is
    // put on their surfaces.
    constexpr double near_equilibrium = 3e-3;
    constexpr unsigned int first_iterations = 2;

    // How often a step that the laws cannot follow is quartered.
    constexpr unsigned int most_returns = 6;

    // Closer to equilibrium than this, factors that will not do are corrected between two iterations.
    constexpr double close_enough_to_correct = .1;

    /// Norm of a change of the unknowns, each in its scale.
    double scaled_norm(const Vector &change, const std::vector<double> &scale)
    {
      double square = 0.;
      for (unsigned int i = 0; i < change.size(); ++i)
        square += (scale[i] * change[i]) * (scale[i] * change[i]);
      return std::sqrt(square);
    }
  } // namespace


  Newton::Newton(Equations &equations, System &system, const NewtonSettings &settings,
                 const std::vector<double> &scale, const std::vector<double> &size, Timers &timers)
    : equations_(equations), system_(system), settings_(settings), scale_(scale), size_(size),
      smallest_motion_(.01 * equations.typical_length()), timers_(timers),
      timer_solve_(timers.section("11 factorization and solve"))
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
        stagnation_{std::max(stagnation_window, stagnation_share * settings_.max_iterations / 100),
                    most_iterations_if_close * settings_.max_iterations,
                    close_to_tolerance * settings_.relaxed_tolerance, settings_.relaxed_tolerance},
        increments_(q.size()), d_(q.size()), start_(q.size()),
        sets_(equations_, system_, settings_, scale_, is_prescribed)
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
        judge_step(residual);
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
      return std::move(result_);
    }

    /// The linear solver found none, or the laws do not follow it.
    NewtonResult without_step()
    {
      return ended(result_.status.good() ? Outcome::singular : Outcome::inadmissible);
    }

    bool assemble()
    {
      result_.status = equations_.assemble(q_, true);
      return result_.status.good();
    }

    /// How far prescribed unknowns still have to go, and how far the increment has moved the others.
    void measure_way()
    {
      pending_ = 0.;
      travelled_ = newton_.smallest_motion_;
      for (unsigned int i = 0; i < q_.size(); ++i)
      {
        if (is_prescribed_[i])
          pending_ = std::max(pending_, std::abs(prescribed_[i] - q_[i]) * scale_[i]);
        travelled_ = std::max(travelled_, std::abs(q_[i] - q_committed_[i]) * scale_[i]);
      }
    }

    bool is_balanced()
    {
      const bool late = iteration_ >= settings_.max_iterations && !last_is_damped_;
      // The edge of a lightly loaded contact zone may travel node by node for ever: after many iterations less will do.
      const double tolerance = late ? settings_.relaxed_tolerance : settings_.force_tolerance;
      const bool fresh = iteration_ == 0 && result_.rounds == 0; // forces of the extrapolated start
      if (fresh || pending_ != 0. || !(residual_ <= tolerance) ||
          (active_set_ != nullptr && !active_set_->consistent(tolerance * norm_.magnitude())))
        return returns_.leave();
      // A damped step is no measure of the error.
      if (last_is_damped_)
        damping_ = StepDamping();
      const bool moved =
        !last_is_damped_ && (last_step_ <= settings_.displacement_tolerance * travelled_ || last_step_ <= 1e-14);
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
      if (!std::isfinite(residual_))
        return true;
      if (pending_ == 0. && stagnation_.reached(result_.residuals))
        return true;
      return iteration_ >= settings_.max_iterations &&
             (residual_ >= stagnation_.near || iteration_ >= stagnation_.most_iterations);
    }

    bool solve(const double shift)
    {
      Timers::Scope timer(newton_.timers_, newton_.timer_solve_);
      return system_.factorize(shift) && system_.solve(increments_, d_);
    }

    bool find_step()
    {
      for (unsigned int i = 0; i < q_.size(); ++i)
        increments_[i] = is_prescribed_[i] ? prescribed_[i] - q_[i] : 0.;
      ++result_.iterations;
      result_.correction_iterations += result_.rounds > 0;
      return find_direction() && find_active_set();
    }

    /// What the damping adds to the tangent of this iteration.
    double damping() const
    {
      return newton_.damps_ && pending_ == 0. ? damping_.stiffness(residual_, norm_.magnitude()) : 0.;
    }

    bool find_direction()
    {
      if (damping() > 0.)
        system_.add_to_diagonal(damping(), scale_);
      // A free rigid motion, or a blank that contact does not yet hold: a shifted matrix still gives a direction.
      return solve(0.) || (assemble() && solve(1e-6));
    }

    /// The set that the step leads to, where it is time.
    bool find_active_set()
    {
      const bool first = result_.rounds == 0 && iteration_ < first_iterations;
      searched_ = active_set_ != nullptr && (first || residual_ <= near_equilibrium);
      const SetSearch::Solve how = [this](const double shift) { return solve(shift); };
      return !searched_ || sets_.run(q_, d_, {residual_, norm_.magnitude(), damping()}, how);
    }

    /// d.R over the unknowns that are not prescribed.
    double work_along_step() const
    {
      double work = 0.;
      for (unsigned int i = 0; i < d_.size(); ++i)
        if (!is_prescribed_[i])
          work += d_[i] * system_.residual()[i];
      return work;
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
      work_start_ = work_along_step();
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
    /// what was foreseen of the increment: a damped one. But a balanced state may be left.
    bool replace_step(double &residual)
    {
      if (searched_ && sets_.is_guess() && !step_again(false, residual))
        return false;
      const bool again = residual > residual_ && newton_.damps_ && residual_ > settings_.force_tolerance &&
                         damping_.bound(residual_, scaled_norm(d_, scale_), foreseen_);
      return !again || step_again(true, residual);
    }

    /// From the same start, with the stiffness that the damping now asks for. @param finds_set look for its set as well
    bool step_again(const bool finds_set, double &residual)
    {
      if (!go(0.))
        return false;
      norm_.relative(); // the magnitude at the start
      const bool made = find_direction() && (!finds_set || find_active_set()) && take_step();
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
      constexpr unsigned int lenient_iterations = 3;
      LineSearch search;
      factor_ = search.search(factor_, work_start_, work_along_step(), iteration_ >= lenient_iterations ? .2 : .8,
                              [&](const double factor) -> std::optional<double> {
                                if (!go(factor))
                                  return std::nullopt;
                                return work_along_step();
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
      if (!equations_.assemble_foreseen(q_) && !assemble())
        return false;
      residual = norm_.relative();
      return true;
    }

    void judge_step(const double residual)
    {
      if (pending_ != 0.)
        return;
      last_is_damped_ = damping() > 0.;
      damping_.judge(residual_, residual, factor_, scaled_norm(d_, scale_));
    }

    void finish_iteration(const double residual)
    {
      residual_ = residual;
      last_step_ = 0.;
      for (unsigned int i = 0; i < q_.size(); ++i)
        last_step_ = std::max(last_step_, factor_ * std::abs(d_[i]) * scale_[i]);
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
    Vector increments_, d_, start_; ///< of prescribed unknowns; the step; where it starts
    SetSearch sets_;
    StepDamping damping_;
    Returns returns_;
    unsigned int iteration_ = 0, n_creeping_ = 0;
    bool last_is_damped_ = false, searched_ = false; ///< the last step; for a set in this iteration
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
