#include "run_summary.h"

#include <deltaform/parameters/command_line.h>
#include <deltaform/results/recorder.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    class Recorder : public Observer
    {
    public:
      Recorder(RunRecord &record, Columns columns, const OutputSettings &output, const Keep keep,
               std::function<double()> seconds)
        : record_(record), columns_(std::move(columns)), output_(output), keep_(keep), seconds_(std::move(seconds)),
          summary_(output)
      {
        record_.columns = columns_.columns();
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
        record_.history.push_back(columns_.row(increment));
        summary_.accepted(increment);
        kept_ = increment.is_last_here && (keep_ == Keep::every_increment || asks_for_tables(output_, increment));
        if (kept_)
          record_.snapshots.push_back(take_snapshot(increment.model, output_, stage_, time_));
      }

      void moved(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
        summary_.moved(increment);
      }

      void ended(const Model &model, const RunOutcome &outcome) override
      {
        if (outcome.exit_status != exit_status::done && outcome.increments > 0 && !kept_)
          record_.snapshots.push_back(take_snapshot(model, output_, stage_, time_));
        record_.exit_status = outcome.exit_status;
        record_.message = outcome.message;
        record_.summary = summary_.json(model, outcome, record_.title, record_.units, seconds_());
      }

    private:
      RunRecord &record_;
      Columns columns_;
      const OutputSettings &output_;
      Keep keep_;
      std::function<double()> seconds_;
      RunSummary summary_;
      double time_ = 0.; ///< of the last accepted increment, and its stage
      std::string stage_;
      bool kept_ = false; ///< it
    };
  } // namespace


  std::unique_ptr<Observer> make_recorder(RunRecord &record, Columns columns, const OutputSettings &output,
                                          const Keep keep, std::function<double()> seconds)
  {
    return std::make_unique<Recorder>(record, std::move(columns), output, keep, std::move(seconds));
  }
} // namespace deltaform
