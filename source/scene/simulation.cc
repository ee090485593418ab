#include <deltaform/base/command_line.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/text.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/simulation.h>

#include <cmath>
#include <utility>

namespace deltaform
{
  Simulation::Simulation(Scene &scene, Recorder &recorder, Journal &journal, Timers &timers)
    : scene_(scene), recorder_(recorder), journal_(journal), timers_(timers),
      timer_attempt_(timers.section("10 start of an increment, residual, length of steps, checks")),
      timer_output_(timers.section("13 output")), problem_(scene.actors, *scene.linear_solver, timers),
      newton_(problem_, problem_.system(), *scene.newton, problem_.scale(), problem_.size(), timers),
      check_(scene.actors)
  {
    if (!scene.output->energies)
      problem_.forget_energy();
    if (scene.output->condition_every > 0)
      condition_ =
        std::make_unique<ConditionReport>(scene.output->condition_every, scene.output->condition_method, timers);
  }


  int Simulation::run()
  {
    if (!resumed_)
      before_ = problem_.committed();
    const auto &solver = problem_.linear_solver();
    journal_.detail("linear solver: " + solver.name + (solver.automatic ? " (automatic)" : "") + ", " +
                    std::to_string(problem_.committed().size()) + " unknowns" +
                    (problem_.on_linear_path() ? ", constant stiffness: one factorization" : ""));
    warn(input_warnings(scene_));
    int status = exit_status::done;
    for (; stage_ < scene_.actors.stages.size() && status == exit_status::done; ++stage_)
    {
      const Stage &stage = scene_.actors.stages[stage_];
      if (resumed_)
        problem_.resume_stage(stage);
      else
      {
        // The state at the end of the last stage is saved.
        if (const std::string wrong = problem_.misplaced_tool(stage); !wrong.empty())
        {
          status = stop(stage, "before its first increment: " + wrong, exit_status::not_converged);
          break;
        }
        problem_.begin_stage(stage);
        if (stage_ == 0)
          recorder_.begin(problem_);
        last_increment_ = 0.;
        step_.reset();
      }
      status = run_stage(stage);
      resumed_ = false;
    }
    journal_.detail(std::to_string(problem_.system().n_factorizations()) + " factorizations" +
                    (problem_.on_linear_path()
                       ? ", " + std::to_string(problem_.system().n_compliances()) + " compliances of contact unknowns"
                       : ""));
    warn(check_.warnings(status));
    recorder_.finish({status, message_, warnings_, increment_, total_iterations_}, problem_);
    // Not before the files are complete: until then, going on from the state before gives the same.
    if (before_giving_up_)
      recorder_.save(std::move(*before_giving_up_));
    recorder_.complete();
    return status;
  }


  int Simulation::run_stage(const Stage &stage)
  {
    std::vector<double> meet = scene_.output->travel_times;
    StepControl control(*scene_.steps,
                        stage.begin,
                        stage.end,
                        stage.first_increment,
                        stage.smallest_increment,
                        stage.largest_increment,
                        meet);
    if (resumed_ && step_)
      control.restore(*step_);
    IncrementCost cost;
    Vector q;
    NewtonResult result;
    while (!control.finished(time_))
    {
      if (increment_ >= scene_.steps->max_increments)
      {
        return stop(stage,
                    std::to_string(increment_) +
                      " increments are done (Solver/Maximal increments). To go on, allow more and --resume",
                    exit_status::not_converged,
                    checkpoint());
      }
      const bool measured = condition_ && condition_->due(increment_ + 1);
      if (measured)
        condition_->watch(problem_);
      const double next = control.next(time_);
      // Cut twice, or as short as it may be: the length of the increment is not the reason.
      const Effort effort =
        problem_.releases_at_once() || (next - time_) * scene_.steps->shrink < stage.smallest_increment ? Effort::all
        : cost.cutbacks >= 2 || control.leaping()                                                       ? Effort::damped
                                                                                                        : Effort::usual;
      const auto linear_iterations_before = problem_.system().n_linear_iterations();
      const std::string failure = attempt(next, effort, q, result);
      cost.linear_iterations += problem_.system().n_linear_iterations() - linear_iterations_before;
      cost.iterations += result.iterations;
      cost.rounds += result.rounds;
      cost.correction_iterations += result.correction_iterations;
      total_iterations_ += result.iterations;
      if (!failure.empty())
      {
        ++cost.cutbacks;
        failed_iterations_ += result.iterations;
        journal_.detail("increment " + std::to_string(increment_ + 1) + " to time " + text::format(next) +
                        " cut back: " + failure);
        if (control.reject(next - time_))
          continue;
        const std::string cause = check_.likely_cause();
        // The failed attempt has moved tools and contact.
        problem_.begin_increment(time_);
        return stop(stage,
                    (cause.empty() ? "" : cause + "; ") + "in increment " + std::to_string(increment_ + 1) + ": " +
                      failure + ". The smallest increment, " + text::rounded(stage.smallest_increment) +
                      ", was reached",
                    promise_failed_ ? exit_status::promise_broken : exit_status::not_converged,
                    checkpoint());
      }

      const double flow_error = scene_.steps->flow_error > 0. ? scene_.actors.blank->flow_error() : 0.;
      last_increment_ = next - time_;
      before_ = problem_.committed();
      if (measured)
        cost.condition = condition_->measure(problem_, q);
      problem_.commit(q);
      time_ = next;
      ++increment_;
      control.accept(result.iterations - result.correction_iterations, flow_error);
      ++since_refinement_;
      const bool refined = refinement_marked();
      const HistoryRow &row = recorder_.record(problem_, stage, time_, increment_, cost, !refined);
      check_.observe(stage, row);
      if (snap_rotation_ > 0.)
        check_.snapped(row, snap_rotation_);
      cost = IncrementCost();
      step_ = control.state();
      accepted_iterations_ = total_iterations_;
      if (refined)
      {
        Checkpoint before = checkpoint();
        const std::string unbalanced = refine(stage);
        if (!unbalanced.empty())
        {
          problem_.begin_increment(time_);
          return stop(stage,
                      "after a refinement of the blank there is no equilibrium: " + unbalanced +
                        ". Refine less at once (Blank/Refinement), or begin with a finer mesh",
                      promise_failed_ ? exit_status::promise_broken : exit_status::not_converged,
                      std::move(before));
        }
      }
      if (const std::string unusable = check_.failure(stage); !unusable.empty())
        return stop(stage, unusable, exit_status::not_converged, checkpoint());
      if (ranks::decided_by_first(recorder_.checkpoint_due()) || control.finished(time_))
        recorder_.save(checkpoint());
    }
    return exit_status::done;
  }


  std::string Simulation::attempt(const double time, const Effort effort, Vector &q, NewtonResult &result)
  {
    const Timers::Remainder rest(timers_, timer_attempt_);
    promise_failed_ = false;
    snap_rotation_ = 0.;
    const auto begin = [&]() {
      problem_.begin_increment(time);
      scene_.actors.blank->begin_increment(last_increment_ > 0 ? (time - time_) / last_increment_ : 0.);
    };
    begin();
    q = problem_.committed();
    if (scene_.steps->extrapolate && last_increment_ > 0)
      q.sadd(1. + (time - time_) / last_increment_, -(time - time_) / last_increment_, before_);

    const auto solve = [&](const Damping damped) {
      const unsigned int before = result.iterations;
      result = newton_.solve(
        q, problem_.prescribed(), problem_.is_prescribed(), problem_.committed(), problem_.force_floor(), damped);
      result.iterations += before;
    };
    const auto failed = [&]() { return !result.converged() && result.outcome != NewtonResult::Outcome::not_corrected; };
    result = NewtonResult();
    solve(Damping::none);
    if (failed())
    {
      // Once more, with first touches soft at first.
      begin();
      if (problem_.soften(1e-4))
      {
        q = problem_.committed();
        solve(Damping::none);
      }
    }
    // The blank may snap to another equilibrium, however short the increment is.
    bool snapped = false;
    if (effort != Effort::usual)
      for (const Damping damping : {Damping::damped, Damping::with_slack})
        if (failed())
        {
          begin();
          q = problem_.committed();
          solve(damping);
          snapped = true;
        }
    if (result.outcome == NewtonResult::Outcome::not_corrected || result.converged())
    {
      std::string broken = problem_.broken_promise();
      if (!broken.empty())
      {
        promise_failed_ = true;
        return broken;
      }
    }
    if (!result.converged())
      return explain(result);

    return too_large(time, effort == Effort::all && (snapped || problem_.releases_at_once()), q);
  }


  std::string Simulation::too_large(const double time, const bool may_snap, const Vector &q)
  {
    snap_rotation_ = 0.;
    Vector dq = q;
    dq -= problem_.committed();
    // A new equilibrium at the same time is no step in time: it may be as far as the mesh was wrong.
    if (time <= time_)
      return "";
    const auto [strain, rotation] = scene_.actors.blank->increment_size(dq);
    if (strain > scene_.steps->largest_strain)
      return "the largest strain increment is " + text::rounded(strain) + ", allowed are " +
             text::rounded(scene_.steps->largest_strain) + " (Solver/Largest strain increment)";
    if (rotation <= scene_.steps->largest_rotation)
      return "";
    // Where the blank snaps through, a shorter increment does not make the way shorter.
    if (may_snap)
    {
      snap_rotation_ = rotation;
      return "";
    }
    return "the largest rotation increment is " + text::rounded(rotation) + ", allowed are " +
           text::rounded(scene_.steps->largest_rotation) + " (Solver/Largest rotation increment)";
  }


  int Simulation::stop(const Stage &stage, const std::string &why, const int status, std::optional<Checkpoint> state)
  {
    message_ = "stage '" + stage.name + "' stopped at time " + text::rounded(time_) + ": " + why + ".";
    journal_.warning(message_);
    before_giving_up_ = std::move(state);
    return status;
  }


  void Simulation::warn(const std::vector<std::string> &texts)
  {
    for (const auto &text : texts)
    {
      journal_.warning(text);
      warnings_.push_back(text);
    }
  }


  std::string Simulation::explain(const NewtonResult &result) const
  {
    std::string where;
    if (result.worst_dof < scene_.actors.blank->n_dofs())
      where = " (largest residual at " + scene_.actors.blank->describe_dof(result.worst_dof) + ")";
    switch (result.outcome)
    {
    case NewtonResult::Outcome::singular:
      if (const std::string failure = problem_.system().linear_failure(); !failure.empty())
        return "the linear solver did not converge: " + failure +
               " (Solver/Maximal linear iterations, Solver/Linear solver tolerance). Try Linear solver = mumps" + where;
      return "the tangent is singular: a part of the blank is free to move, or a limit load is reached" + where;
    case NewtonResult::Outcome::inadmissible:
      return std::string(result.status.cause) + ", cell " + std::to_string(result.status.place);
    case NewtonResult::Outcome::not_corrected:
      return "the corrections of the penalty factors did not end after " + std::to_string(result.rounds) + " rounds" +
             where;
    default:
      break;
    }
    // How it began and how it ended says what went wrong; there may be hundreds between.
    constexpr std::size_t first = 3, last = 5;
    const auto &history = result.residuals;
    std::string residuals;
    for (std::size_t i = 0; i < history.size(); ++i)
      if (i < first || i + last >= history.size())
        residuals += (i == 0 ? "" : " ") + text::format(std::round(history[i] * 1e12) / 1e12);
      else if (i == first)
        residuals += " ...";
    return "Newton did not converge in " + std::to_string(result.iterations) + " iterations" + where +
           ", relative residuals " + residuals;
  }
} // namespace deltaform
