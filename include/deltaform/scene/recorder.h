#pragma once

#include <deltaform/base/journal.h>
#include <deltaform/base/timers.h>
#include <deltaform/results/history.h>
#include <deltaform/scene/scene.h>

namespace deltaform
{
  struct Checkpoint;
  struct IncrementCost;

  /// How a run has ended.
  struct RunOutcome
  {
    int exit_status;
    std::string message; ///< why it stopped; empty if it is done
    std::vector<std::string> warnings; ///< what makes input or result doubtful
    unsigned int increments, iterations;
  };

  /// Writes what the scene asks for, after every accepted increment. Files and columns: doc/output.md.
  class Recorder
  {
  public:
    /// @param start go on with the files in the folder from this state; null: begin new ones
    Recorder(Scene &scene,
             const std::string &folder,
             Journal &journal,
             Timers &timers,
             const Checkpoint *start = nullptr);
    ~Recorder();

    /// The first stage begins: the picture that opens the series shows the undeformed blank and the tools at their
    /// start.
    void begin(const FormingProblem &problem);

    /// An increment was accepted. @param tables if not, tables and pictures of this time will come with a refined mesh
    /// @return its row of the history
    const HistoryRow &record(const FormingProblem &problem,
                             const Stage &stage,
                             double time,
                             unsigned int increment,
                             const IncrementCost &cost,
                             bool tables = true);

    /// The problem of @p start has been loaded: what its last increment was.
    void resume(const FormingProblem &problem, const Checkpoint &start);

    /// Is it time to save a state?
    bool checkpoint_due() const;

    /// What a Recorder goes on from.
    std::string state() const;

    /// Save a state in the folder, like pictures while the run goes on.
    void save(Checkpoint state);

    /// Until every file is written. @throws SceneError if one of them cannot be
    void complete();

    /// The run has ended.
    void finish(const RunOutcome &outcome, const FormingProblem &problem);

  private:
    struct Files;
    std::unique_ptr<Files> files_;
  };
} // namespace deltaform
