#pragma once

#include <deltaform/analysis/observer_list.h>
#include <deltaform/analysis/state.h>
#include <deltaform/checks/function_values.h>
#include <deltaform/conditions/conditions.h>
#include <deltaform/conditions/stage_ends.h>
#include <deltaform/increment/increment.h>
#include <deltaform/increment/step_control.h>
#include <deltaform/model/model.h>
#include <deltaform/model/next_state.h>
#include <deltaform/model/workspace.h>
#include <deltaform/process/journal.h>
#include <deltaform/process/timers.h>
#include <deltaform/reports/checkpoint.h>
#include <deltaform/reports/observer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// Exit status of a run that ends because an increment was given up.
  int status_of(const Rejected &rejected);

  /// How the stages of a scene are computed.
  struct AnalysisSettings
  {
    const LinearSolverSettings &linear_solver;
    const NewtonSettings &newton;
    const StepSettings &steps;
    std::vector<double> meet; ///< times that increments have to end at
    bool energies; ///< are works and energies asked for?
    std::vector<Checkpoint::Entry> entries; ///< of the scene, saved with every state
  };

  /**
   * Computes the stages of a scene increment by increment, all at once by run() or one by one:
   *
   *     Analysis analysis(actors, settings, journal, timers);
   *     analysis.begin();
   *     while (analysis.advance())
   *       std::cout << analysis.model().tool_forces()[0];
   *     const int status = analysis.end();
   *
   * It writes nothing; observers do. It works on the actors themselves: of one scene, one analysis at a time.
   */
  class Analysis
  {
  public:
    Analysis(Actors &actors, const AnalysisSettings &settings, Journal &journal, Timers &timers);

    void add(std::unique_ptr<Observer> observer)
    {
      observers_.add(std::move(observer));
    }

    /// Add a warning about the input to those of the outcome.
    void warn(const std::vector<std::string> &texts);

    /// Begin with the blank that an earlier operation has left, see Blank::formed(). Belongs before begin().
    /// @throws SceneError if the blank of the scene cannot be that one
    void start_from(const KeyedArrays &formed)
    {
      model_.start_from(formed);
    }

    /// Go on from a saved state. Belongs before begin(). @throws SceneError if it does not fit the stages of the scene
    void resume(const Checkpoint &start);

    /// The state after the last accepted increment, as a value.
    State state() const;

    /// Go to @p state, forwards or back, but not back over a refinement of a solid; also to that of another analysis
    /// whose scene has the same entries. Observers are told by moved(). @throws SceneError if it does not fit
    void set_state(const State &state);

    /// All stages. @return exit status: done, not_converged or promise_broken
    int run();

    void begin();

    /// Compute the next increment, with all attempts that it takes. @return false: there was none left, or it failed
    bool advance();

    /// Tell the observers how the run has ended. @return exit status
    int end();

    /// The state after the last accepted increment, with what the observers remember, for a file.
    Checkpoint checkpoint() const;

    const Model &model() const
    {
      return model_;
    }

    double time() const
    {
      return model_.time();
    }

    /// Why the run stopped; empty if it did not.
    const std::string &message() const
    {
      return outcome_.message;
    }

  private:
    /// Begin the stages that are due. @return false if there is none left
    bool enter_stage();

    const Stage &stage() const
    {
      return actors_.stages[state_.stage];
    }

    IncrementResult attempt(double end, Effort effort);
    bool accept(double next, const IncrementResult &result); ///< @return false if the run has stopped

    /// Refine what is marked, pass by pass, each an increment at the same time. @return false if the run has stopped
    bool refine();

    bool refinement_marked();
    void regain_equilibrium();

    /// The stage ends before its end time: the time up to there is skipped.
    void end_stage_early();

    void notify(const AcceptedIncrement &increment);
    AcceptedIncrement accepted(const IncrementCost &cost) const;

    /// The run stops, and can be resumed from @p state (none: from the one that was saved last). @return false
    bool stop(const std::string &why, int status, std::optional<Checkpoint> state = std::nullopt);

    /// No attempt at an increment succeeds.
    bool give_up(const Rejected &rejected);

    Actors &actors_;
    AnalysisSettings settings_;
    Journal &journal_;
    Timers &timers_;
    Timers::Index timer_attempt_, timer_output_;
    FunctionValues functions_;
    Model model_;
    Workspace workspace_;
    NextState next_;
    Newton newton_;
    Increment increment_;
    Conditions conditions_;
    StageEnds ends_;
    ObserverList observers_;

    State state_; ///< accepted; that of the model is with the model
    bool resumed_ = false; ///< in the middle of the current stage
    std::optional<StepControl> control_; ///< of the current stage
    IncrementCost cost_; ///< of the attempts at the next increment so far

    RunOutcome outcome_; ///< so far; iterations with those since the last accepted increment
  };
} // namespace deltaform
