// summary.json and timing.json, and the last lines on the console.
#include "run_summary.h"

#include <deltaform/io/atomic_file.h>
#include <deltaform/results/observers.h>

#include <ostream>

namespace deltaform
{
  namespace
  {
    class SummaryObserver : public Observer
    {
    public:
      SummaryObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), summary_(output)
      {
      }

      Turn turn() const override
      {
        return Turn::sums_up;
      }

      void begin(const Model &model, const Stage &stage) override
      {
        summary_.begin(model, stage);
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        summary_.accepted(increment);
      }

      void moved(const AcceptedIncrement &increment) override
      {
        summary_.moved(increment);
      }

      std::vector<std::string> missing(const Model &model) const override
      {
        return summary_.missing(model);
      }

      void ended(const Model &model, const RunOutcome &outcome) override
      {
        folder_.writer().wait();
        const std::string summary =
          summary_.json(model, outcome, folder_.title(), folder_.units_label(), folder_.timers().total());
        // The summary comes last: where it says that a run is done, nothing is missing.
        write_file_atomically(folder_.path("timing.json"),
                              [&](std::ostream &out) { folder_.timers().write_json(out); });
        write_file_atomically(folder_.path("summary.json"), [&](std::ostream &out) { out << summary << '\n'; });
        folder_.journal().finish_progress();
        folder_.journal().note(summary_.last_line(model, outcome, folder_.timers().total()));
        folder_.journal().note("results in " + folder_.name());
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        summary_.save(archive);
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        summary_.load(archive);
      }

    private:
      ResultsFolder &folder_;
      RunSummary summary_;
    };

    const ObserverMakers::Entry
      entry("summary", "summary.json and timing.json", make_observer<SummaryObserver>);
  } // namespace
} // namespace deltaform
