#include <deltaform/increment/viscous_motion.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    // A step of which the next one takes its start need not be exact: its relative residual. Forces of the medium,
    // relative as well, below which the blank is nearly at rest, so that steps are exact; in force tolerances: at rest.
    constexpr double rough = 1e-3, near_rest = 1e-2, at_rest = .01;

    // Viscosity over the mean stiffness, of the first step, and where no step will ever be solved; its factor after one
    // that was not, and for how many steps it stays so.
    constexpr double first_viscosity = 1e-3, largest_viscosity = 1e4, resistance = 4.;
    constexpr unsigned int pause = 3;

    // Steps after which an equilibrium is looked for, and after which it is again; steps at rest whose forces do not
    // balance, after which they may be so (the condition "force balance" tells).
    constexpr unsigned int first_trial = 4, next_trials = 8, most_unbalanced = 4;

    NewtonSettings settings_of_rough_steps(NewtonSettings settings)
    {
      settings.force_tolerance = std::max(settings.force_tolerance, rough);
      settings.relaxed_tolerance = std::max(settings.relaxed_tolerance, rough);
      return settings;
    }

    /// Of the viscosity, for the next step after one that took so many iterations.
    double share_that_stays(const unsigned int iterations)
    {
      return iterations <= 3 ? .25 : iterations <= 8 ? .5
                                                     : .8;
    }
  } // namespace


  ViscousMotion::ViscousMotion(IncrementProblem &problem, Newton &newton, Vector &q, const unsigned int most_iterations)
    : problem_(problem), newton_(newton), q_(q), trial_(q), most_iterations_(most_iterations),
      viscous_(problem, newton.system(), newton.scale()), rough_(settings_of_rough_steps(newton.settings())),
      roughly_(newton.for_viscous_equations(viscous_, rough_)),
      exactly_(newton.for_viscous_equations(viscous_, newton.settings())),
      viscosity_(first_viscosity), next_trial_(first_trial)
  {
  }


  NewtonResult ViscousMotion::run()
  {
    if (!problem_.assemble(q_, true).good())
      return ended(NewtonResult::Outcome::inadmissible);
    const double stiffness = mean_stiffness();
    viscous_.begin_step(q_, 0.);
    remember_residual();
    if (problem_.active_set() != nullptr)
      problem_.active_set()->keep();
    while (may_go_on() && viscosity_ < largest_viscosity && ranks::max(interruption::signal()) == 0)
    {
      viscous_.begin_step(q_, viscosity_ * stiffness);
      if (!solve(is_nearly_at_rest() ? exactly_ : roughly_) || !descends())
      {
        // What the linear solver does not solve is no matter of the medium.
        if (!newton_.system().linear_failure().empty())
          return ended(NewtonResult::Outcome::singular);
        resist();
        continue;
      }
      const double forces = forces_of_medium();
      if (is_nearly_at_rest() && last_.converged() && forces <= at_rest * newton_.settings().force_tolerance &&
          (problem_.imbalance() <= newton_.settings().balance_tolerance || n_unbalanced_++ == most_unbalanced))
        return ended(last_.outcome);
      if (is_free())
        return ended(NewtonResult::Outcome::singular);
      forces_ = forces;
      go_on();
      if (finds_equilibrium())
        return ended(last_.outcome);
    }
    return ended(NewtonResult::Outcome::diverged);
  }


  bool ViscousMotion::solve(Newton &newton)
  {
    trial_ = q_;
    last_ = newton.solve(trial_, problem_.prescribed(), problem_.is_prescribed(), problem_.committed(),
                         problem_.force_floor());
    n_iterations_ += last_.iterations;
    return last_.converged() || (&newton == &roughly_ && last_.outcome == NewtonResult::Outcome::not_corrected);
  }


  void ViscousMotion::resist()
  {
    if (problem_.active_set() != nullptr)
      problem_.active_set()->go_back();
    viscosity_ *= resistance;
    pause_ = pause;
  }


  void ViscousMotion::go_on()
  {
    q_ = trial_;
    remember_residual();
    if (problem_.active_set() != nullptr)
      problem_.active_set()->keep();
    ++n_steps_;
    if (pause_ > 0)
      --pause_;
    else
      viscosity_ *= share_that_stays(last_.iterations);
  }


  bool ViscousMotion::finds_equilibrium()
  {
    if (!is_nearly_at_rest() || n_steps_ < next_trial_)
      return false;
    next_trial_ = n_steps_ + next_trials;
    if (solve(newton_) && descends())
      return true;
    if (problem_.active_set() != nullptr)
      problem_.active_set()->go_back();
    return false;
  }


  bool ViscousMotion::may_go_on()
  {
    if (n_iterations_ >= most_iterations_ && is_nearly_at_rest())
      most_iterations_ += std::exchange(last_way_, 0U);
    return n_iterations_ < most_iterations_;
  }


  bool ViscousMotion::is_nearly_at_rest() const
  {
    return forces_ <= near_rest;
  }


  bool ViscousMotion::descends() const
  {
    double work = 0.;
    for (DofIndex i = 0; i < trial_.size(); ++i)
      work += (trial_[i] - q_[i]) * residual_[i];
    return work <= 0. || forces_ <= newton_.settings().relaxed_tolerance;
  }


  void ViscousMotion::remember_residual()
  {
    const std::vector<bool> &is_prescribed = problem_.is_prescribed();
    residual_.reinit(q_.size());
    for (DofIndex i = 0; i < q_.size(); ++i)
      residual_[i] = is_prescribed[i] ? 0. : newton_.system().residual()[i] - viscous_.force(i, q_);
  }


  bool ViscousMotion::is_free() const
  {
    double way = 0., size = 0.;
    for (DofIndex i = 0; i < trial_.size(); ++i)
    {
      size = std::max(size, newton_.size()[i] * newton_.scale()[i]);
      way = std::max(way, std::abs(trial_[i] - problem_.committed()[i]) * newton_.scale()[i]);
    }
    return way > size;
  }


  double ViscousMotion::forces_of_medium() const
  {
    const System &system = newton_.system();
    double square = 0., all = problem_.force_floor() * problem_.force_floor();
    for (DofIndex i = 0; i < trial_.size(); ++i)
    {
      const double force = viscous_.force(i, trial_) / newton_.scale()[i];
      const double magnitude = system.magnitude()[i] / newton_.scale()[i];
      square += force * force;
      all += magnitude * magnitude;
    }
    return std::sqrt(square / all);
  }


  double ViscousMotion::mean_stiffness() const
  {
    const std::vector<bool> &is_prescribed = problem_.is_prescribed();
    const System &system = newton_.system();
    double sum = 0.;
    unsigned int n = 0;
    for (DofIndex i = 0; i < q_.size(); ++i)
      if (const double stiffness = system.diagonal(i), scale = newton_.scale()[i]; !is_prescribed[i] && stiffness > 0.)
      {
        sum += std::log(stiffness / (scale * scale));
        ++n;
      }
    return n > 0 ? std::exp(sum / n) : 1.;
  }


  NewtonResult ViscousMotion::ended(const NewtonResult::Outcome outcome)
  {
    q_ = trial_;
    last_.outcome = outcome;
    last_.iterations = n_iterations_;
    return std::move(last_);
  }
} // namespace deltaform
