#include <deltaform/analysis/analysis.h>
#include <deltaform/analysis/mesh_change.h>
#include <deltaform/checks/tool_placement.h>
#include <deltaform/increment/shortest_failure.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/ranks.h>
#include <deltaform/reports/accepted_increment.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    std::string solver_in_words(const Model &model)
    {
      const auto &solver = model.discretization().linear_solver();
      return "linear solver: " + solver.name + (solver.automatic ? " (automatic)" : "") + ", " +
             std::to_string(model.committed().size()) + " unknowns" +
             (model.discretization().on_linear_path() ? ", constant stiffness: one factorization" : "");
    }

    std::string effort_in_words(const Discretization &discretization, const Workspace &workspace)
    {
      return std::to_string(workspace.n_factorizations()) + " factorizations" +
             (discretization.on_linear_path()
                ? ", " + std::to_string(workspace.system().n_compliances()) + " compliances of contact unknowns"
                : "");
    }

    std::string enough_in_words(const unsigned int n_increments)
    {
      return std::to_string(n_increments) +
             " increments are done (Solver/Maximal increments). To go on, allow more and --resume";
    }

    /// Why there are no more increments, whether the next one can be solved or not; empty if there are.
    std::string too_many(const State &state, const StepSettings &steps, const double end)
    {
      return state.n_increments >= steps.max_increments ? enough_in_words(state.n_increments)
                                                        : state.pace.never_ends(end, steps.max_increments);
    }

    std::string cut_back_in_words(const Rejected &rejected, const unsigned int increment, const double end)
    {
      return "increment " + std::to_string(increment) + " to time " + text::format(end) + " cut back: " +
             rejected.sentence + (rejected.residuals.empty() ? "" : ", relative residuals " + rejected.residuals);
    }

    std::string what_else_to_try(const Rejected &rejected, const unsigned int increment, const bool is_sheet)
    {
      if (rejected.kind == Rejected::Kind::promise_broken)
        return "a larger allowed penetration";
      if (rejected.kind == Rejected::Kind::too_large)
        return "shorter elements there";
      if (increment == 1)
        return "supports that hold the blank where only friction does";
      return is_sheet ? "shorter elements at radii" : "shorter elements where contact begins and ends";
    }

    /// @param cause that is likely; empty if none is known
    std::string in_words(const std::string &cause, const Rejected &rejected, const unsigned int increment,
                         const Stage &stage, const bool is_sheet)
    {
      const bool at_once = rejected.kind == Rejected::Kind::too_large;
      return "in increment " + std::to_string(increment) + ": " + rejected.sentence + ". The smallest increment, " +
             text::rounded(stage.smallest_increment) + ", was reached" +
             (!cause.empty() ? ". The likely cause: " + cause + ". Else try"
              : at_once      ? ": what happens at once is a neck, a fold or a snap. Try"
                             : ". Try") +
             " a smaller Steps/" + stage.name + "/Smallest increment, or " +
             what_else_to_try(rejected, increment, is_sheet);
    }

    std::string does_not_find_the_blank(const std::string &tool, const Stage &stage)
    {
      return "stage '" + stage.name + "': tool '" + tool +
             "' is driven by a force and does not find the blank along its Direction, so that nothing resists it. "
             "Look at its Position, Side and Direction";
    }
  } // namespace


  int status_of(const Rejected &rejected)
  {
    return rejected.kind == Rejected::Kind::promise_broken ? exit_status::promise_broken : exit_status::not_converged;
  }


  Analysis::Analysis(Actors &actors, const AnalysisSettings &settings, Journal &journal, Timers &timers)
    : actors_(actors), settings_(settings), journal_(journal), timers_(timers),
      timer_attempt_(timers.section("10 start of an increment, residual, length of steps, checks")),
      timer_output_(timers.section("13 output")), functions_(actors), model_(actors, settings.linear_solver, timers),
      workspace_(model_), next_(model_, workspace_),
      newton_(next_, workspace_.system(), settings.newton, model_.discretization().numbering().scale,
              model_.discretization().numbering().size, timers),
      increment_(next_, newton_, settings.steps), conditions_(actors), ends_(actors),
      outcome_{exit_status::done, "", {}, 0, 0, std::nullopt}
  {
    newton_.limit_sets(state_.set_limit);
    if (!settings.energies)
      model_.count_no_energy();
  }


  void Analysis::warn(const std::vector<std::string> &texts)
  {
    for (const auto &text : texts)
    {
      journal_.warning(text);
      outcome_.warnings.push_back(text);
    }
  }


  int Analysis::run()
  {
    begin();
    while (advance())
    {
    }
    return end();
  }


  void Analysis::begin()
  {
    journal_.detail(solver_in_words(model_));
  }


  int Analysis::end()
  {
    journal_.detail(effort_in_words(model_.discretization(), workspace_));
    const bool done = outcome_.exit_status == exit_status::done;
    warn(conditions_.warnings(done));
    if (done)
      observers_.tell([&](const Observer &observer) { warn(observer.missing(model_)); });
    const Timers::Scope timer(timers_, timer_output_);
    outcome_.increments = state_.n_increments;
    observers_.tell([&](Observer &observer) { observer.ended(model_, outcome_); });
    return outcome_.exit_status;
  }


  bool Analysis::enter_stage()
  {
    while (!control_ || control_->finished(time()) || !ends_.reached().empty())
    {
      if (control_)
      {
        if (!control_->finished(time()))
          end_stage_early();
        control_.reset();
        ++state_.stage;
      }
      if (state_.stage >= actors_.stages.size())
        return false;
      if (!resumed_)
      {
        // The state at the end of the last stage is saved.
        if (const auto wrong = misplaced_tool(actors_, model_.stage(), model_.committed(), stage()); !wrong.empty())
          return stop("before its first increment: " + wrong, exit_status::not_converged);
        for (const auto &tool : model_.begin_stage(stage()))
          warn({does_not_find_the_blank(tool, stage())});
        if (state_.stage == 0)
        {
          if (model_.formed_start().drop_transfer_error())
            regain_equilibrium();
          else if (const std::string left = model_.formed_start().left_over(); !left.empty())
            journal_.note(left);
          MeshChange::refine_unstressed(state_, model_, workspace_, journal_);
          const Timers::Scope timer(timers_, timer_output_);
          observers_.tell([&](Observer &observer) { observer.begin(model_, stage()); });
        }
        state_.predictor.restart();
        state_.step.reset();
        state_.pace = Pace(time());
      }
      control_.emplace(settings_.steps, stage().begin, stage().end, stage().first_increment,
                       stage().smallest_increment, stage().largest_increment, settings_.meet);
      ends_.enter_stage(stage());
      if (resumed_ && state_.step)
        control_->restore(*state_.step);
      // A run may have been killed between the state of its last increment and its end.
      if (std::exchange(resumed_, false))
        if (const std::string unusable = conditions_.failure(stage()); !unusable.empty())
          return stop(unusable, exit_status::not_converged, checkpoint());
    }
    return true;
  }


  bool Analysis::advance()
  {
    if (outcome_.exit_status != exit_status::done || !enter_stage())
      return false;
    if (const std::string why = too_many(state_, settings_.steps, stage().end); !why.empty())
      return stop(why, exit_status::not_converged, checkpoint());
    observers_.announce(model_, workspace_, state_.n_increments + 1);
    ShortestFailure failure;
    for (;;)
    {
      const double next = ends_.shorten(control_->next(time()));
      if (const int signal = static_cast<int>(ranks::max(interruption::signal())); signal != 0)
        return stop("ended by " + interruption::name(signal) + "; the state is saved, and --resume goes on from it",
                    exit_status::by_signal + signal, checkpoint());
      if (const auto wrong = functions_.find_wrong(stage(), next))
        return stop(wrong->to_string(), exit_status::not_converged, checkpoint());
      const Effort effort = model_.releases_at_once()
                              ? Effort::all
                              : control_->effort(next - time(), cost_.cutbacks, state_.predictor.last_length() > 0.);
      const IncrementResult result = attempt(next, effort);
      cost_ += result.cost;
      if (!result.rejected)
        return accept(next, result);
      cost_.count_failure(result.cost.iterations);
      journal_.detail(cut_back_in_words(*result.rejected, state_.n_increments + 1, next));
      state_.predictor.passage().distrust();
      failure.add(*result.rejected, next - time());
      if (!control_->reject(next - time()))
        return give_up(failure.reason());
    }
  }


  void Analysis::end_stage_early()
  {
    journal_.note("stage '" + stage().name + "' ends at time " + text::rounded(time()) + ": " + ends_.reached());
    state_.skipped.add(time(), stage().end);
    actors_.skip(state_.skipped);
  }


  IncrementResult Analysis::attempt(const double end, const Effort effort)
  {
    const Timers::Remainder rest(timers_, timer_attempt_);
    workspace_.follow_mesh();
    const IncrementStart start{end, end - time(), settings_.steps.extrapolate, state_.predictor,
                               model_.blank().chain()};
    IncrementResult result = increment_.attempt(start, effort);
    outcome_.iterations += result.cost.iterations;
    return result;
  }


  bool Analysis::accept(const double next, const IncrementResult &result)
  {
    const double flow_error = settings_.steps.flow_error > 0. ? actors_.blank->flow_error() : 0.;
    const double length = next - time();
    state_.predictor.accept(model_.committed(), result.q, length, workspace_.system(),
                            model_.blank().chain());
    observers_.tell([&](Observer &observer) { observer.solved(model_, workspace_.system(), result.q); });
    workspace_.before_contact({});
    model_.commit(result.q, workspace_);
    ++state_.n_increments;
    control_->accept(result.iterations_of_its_length(), flow_error, result.longest(length), cost_.iterations);
    control_->shorten(state_.predictor.passage().longest());
    state_.pace.accept(next, cost_.iterations);
    state_.set_limit.accept(length, cost_.iterations);
    ++state_.since_refinement;
    const bool refined = refinement_marked();
    AcceptedIncrement increment = accepted(std::exchange(cost_, IncrementCost()));
    increment.snap = result.snap;
    increment.is_last_here = !refined;
    conditions_.observe(increment);
    ends_.observe(increment);
    ends_.end(conditions_.stage_end(stage()));
    increment.ends_stage |= !ends_.reached().empty();
    const std::string unusable = conditions_.failure(stage());
    state_.step = control_->state();
    notify(increment);
    if (refined && !refine())
      return false;
    return unusable.empty() || stop(unusable, exit_status::not_converged, checkpoint());
  }


  AcceptedIncrement Analysis::accepted(const IncrementCost &cost) const
  {
    AcceptedIncrement result(model_, stage(), time(), state_.n_increments, cost);
    result.ends_stage = control_ && control_->finished(time());
    result.checkpoint = [this]() { return checkpoint(); };
    return result;
  }


  void Analysis::notify(const AcceptedIncrement &increment)
  {
    state_.n_iterations = outcome_.iterations;
    const Timers::Scope timer(timers_, timer_output_);
    observers_.tell([&](Observer &observer) { observer.accepted(increment); });
  }


  bool Analysis::stop(const std::string &why, const int status, std::optional<Checkpoint> state)
  {
    outcome_.message = "stage '" + stage().name + "' stopped at time " + text::rounded(time()) + ": " + why + ".";
    journal_.warning(outcome_.message);
    outcome_.exit_status = status;
    outcome_.state = std::move(state);
    return false;
  }


  bool Analysis::give_up(const Rejected &rejected)
  {
    workspace_.begin(time());
    return stop(in_words(conditions_.likely_cause(rejected.sections), rejected, state_.n_increments + 1, stage(),
                         model_.blank().fields().is_sheet()),
                status_of(rejected), checkpoint());
  }
} // namespace deltaform
