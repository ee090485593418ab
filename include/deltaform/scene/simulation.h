#pragma once

#include <deltaform/base/journal.h>
#include <deltaform/base/timers.h>
#include <deltaform/scene/checkpoint.h>
#include <deltaform/scene/condition_report.h>
#include <deltaform/scene/forming_problem.h>
#include <deltaform/scene/recorder.h>
#include <deltaform/scene/result_check.h>
#include <deltaform/scene/scene.h>

#include <optional>

namespace deltaform
{
  /// What an accepted increment cost, and how well conditioned it was.
  struct IncrementCost
  {
    unsigned int iterations = 0, rounds = 0, cutbacks = 0;
    unsigned int linear_iterations = 0; ///< of an iterative linear solver
    unsigned int correction_iterations = 0; ///< of the iterations, those after the first convergence
    std::optional<ConditionNumbers> condition; ///< where asked
  };

  /// Runs the stages of a scene increment by increment.
  class Simulation
  {
  public:
    Simulation(Scene &scene, Recorder &recorder, Journal &journal, Timers &timers);

    /// Go on from a saved state. @throws SceneError if it does not fit the stages of the scene
    void resume(const Checkpoint &start);

    /// @return exit status: done, not_converged or promise_broken
    int run();

  private:
    /// One stage. @return exit status
    int run_stage(const Stage &stage);

    /// Are refinements due, and is there anything to refine?
    bool refinement_marked();

    /// Refine what is marked and restore equilibrium at the same time, pass by pass; each is an increment of its own.
    /// @return empty, else why there is no equilibrium
    std::string refine(const Stage &stage);

    /// The state after the last accepted increment.
    Checkpoint checkpoint() const;

    /// What is tried to find an equilibrium.
    enum class Effort : unsigned char
    {
      usual,
      damped, ///< damped steps as well: shorter increments did not help
      all ///< the shortest increment: where the blank snaps through, strains and rotations may be large
    };

    /// Try the increment from the committed state to @p time. @return empty if accepted, else the cause of the failure
    std::string attempt(double time, Effort effort, Vector &q, NewtonResult &result);

    /// Is the increment, which ends at @p time, not too large? @return empty, else what is
    std::string too_large(double time, bool may_snap, const Vector &q);

    /// The run stops in this stage, and can be resumed from @p state (none: from the one that was saved last). @return
    /// exit status @p status
    int stop(const Stage &stage, const std::string &why, int status, std::optional<Checkpoint> state = std::nullopt);

    /// Say what makes the input or the result doubtful, on the console, in the log and in summary.json.
    void warn(const std::vector<std::string> &texts);

    /// Why a Newton solve failed, in words.
    std::string explain(const NewtonResult &result) const;

    Scene &scene_;
    Recorder &recorder_;
    Journal &journal_;
    Timers &timers_;
    Timers::Index timer_attempt_, timer_output_;
    FormingProblem problem_;
    Newton newton_;
    std::unique_ptr<ConditionReport> condition_; ///< none if not asked for

    double time_ = 0, last_increment_ = 0;
    unsigned int increment_ = 0, total_iterations_ = 0, failed_iterations_ = 0;
    bool promise_failed_ = false;
    Vector before_; ///< the solution one increment before the committed one

    ResultCheck check_;
    double snap_rotation_ = 0; ///< of the last attempt, where it passed the limit in a snap; else 0
    std::vector<std::string> warnings_;
    std::string message_; ///< why the run stopped

    unsigned int stage_ = 0; ///< index of the current one
    bool resumed_ = false; ///< in the middle of the current stage
    /// After the last accepted increment of the stage, if there is one: what a resumed run goes on with.
    std::optional<StepControl::State> step_;
    unsigned int accepted_iterations_ = 0;
    unsigned int since_refinement_ = 0; ///< increments
    std::optional<Checkpoint> before_giving_up_; ///< what a run that failed can be resumed from
  };
} // namespace deltaform
