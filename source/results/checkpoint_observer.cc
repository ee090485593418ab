// checkpoint.bin: the states from which a run goes on.
#include <deltaform/process/ranks.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/observers.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    class CheckpointObserver : public Observer
    {
    public:
      CheckpointObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), interval_(output.checkpoint_interval)
      {
      }

      Turn turn() const override
      {
        return Turn::saves;
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        if (!increment.is_last_here)
          return;
        const bool due = folder_.timers().total() - saved_at_ >= interval_;
        if (ranks::decided_by_first(due) || increment.ends_stage)
          save_state(increment.checkpoint());
      }

      void ended(const Model &, const RunOutcome &outcome) override
      {
        // Not before the other files are complete: until then, going on from the state before gives the same.
        folder_.writer().wait();
        if (outcome.state)
          save_state(*outcome.state);
        folder_.writer().wait();
      }

    private:
      /// After the pictures that it counts on.
      void save_state(Checkpoint state)
      {
        folder_.writer().run([state = std::move(state), folder = folder_.name()]() { state.write(folder); });
        saved_at_ = folder_.timers().total();
      }

      ResultsFolder &folder_;
      double interval_; ///< seconds
      double saved_at_ = 0.; ///< seconds since the start
    };

    const ObserverMakers::Entry
      entry("checkpoint", "checkpoint.bin, the state to go on from", make_observer<CheckpointObserver>);
  } // namespace
} // namespace deltaform
