#pragma once

#include <deltaform/base/journal.h>
#include <deltaform/base/timers.h>
#include <deltaform/scene/scene.h>

namespace deltaform
{
  struct IncrementCost;

  /// Writes what the scene asks for, after every accepted increment. Files and columns: doc/output.md.
  class Recorder
  {
  public:
    Recorder(Scene &scene, const std::string &folder, Journal &journal, Timers &timers);
    ~Recorder();

    /// An increment was accepted.
    void record(const FormingProblem &problem,
                const Stage &stage,
                double time,
                unsigned int increment,
                const IncrementCost &cost);

    /// The run has ended.
    void finish(int exit_status, const FormingProblem &problem, unsigned int increments, unsigned int iterations);

  private:
    struct Files;
    std::unique_ptr<Files> files_;
  };
} // namespace deltaform
