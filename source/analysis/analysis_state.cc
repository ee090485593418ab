// The state of an analysis, and going to one.
#include <deltaform/analysis/analysis.h>
#include <deltaform/io/byte_stream.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <sstream>

namespace deltaform
{
  namespace
  {
    /// @throws SceneError if the stage of the state is not there, or not at its time
    void check_fits(const State &state, const std::vector<Stage> &stages)
    {
      const double time = state.time();
      if (state.stage >= stages.size() || !(time >= stages[state.stage].begin && time <= stages[state.stage].end))
        throw SceneError("Cannot resume: the saved state at time " + text::format(time) + " is in stage number " +
                         std::to_string(state.stage + 1) + ", which the scene now has " +
                         (state.stage < stages.size()
                            ? "from time " + text::format(stages[state.stage].begin) + " to " +
                                text::format(stages[state.stage].end)
                            : "no more") +
                         " (Steps). Start again without --resume.");
    }

    State state_of(const Checkpoint &start)
    {
      State state;
      std::istringstream own(start.state);
      state.load(own);
      if (state.n_increments != start.increment || state.stage != start.stage || state.time() != start.time ||
          !state.predictor.fits(state.model.unknowns.size()))
        throw SceneError("Cannot resume: the saved state contradicts itself, so it is damaged. Start again without "
                         "--resume.");
      return state;
    }
  } // namespace


  State Analysis::state() const
  {
    State result = state_;
    result.model = model_.state();
    result.conditions = conditions_.save();
    result.ends = ends_.save();
    return result;
  }


  void Analysis::set_state(const State &state)
  {
    const auto &stages = actors_.stages;
    check_fits(state, stages);
    model_.set_state(state.model, stages[state.stage]);
    workspace_.begin(time());
    state_ = state;
    state_.model = ModelState();
    conditions_.load(state.conditions);
    ends_.load(state.ends);
    actors_.skip(state_.skipped);
    outcome_.iterations = state_.n_iterations;
    resumed_ = true;
    control_.reset();
    cost_ = IncrementCost();
    outcome_.exit_status = exit_status::done;
    outcome_.message.clear();
    outcome_.state.reset();
    observers_.tell([last = accepted(IncrementCost())](Observer &observer) { observer.moved(last); });
  }


  Checkpoint Analysis::checkpoint() const
  {
    Checkpoint result;
    result.scene = settings_.entries;
    result.increment = state_.n_increments;
    result.time = time();
    result.stage = state_.stage;
    ByteStream own;
    state().save(own.stream());
    result.state = own.take();
    result.observers = observers_.save();
    return result;
  }


  void Analysis::resume(const Checkpoint &start)
  {
    set_state(state_of(start));
    observers_.load(start.observers);
    observers_.tell([last = accepted(IncrementCost())](Observer &observer) { observer.resumed(last); });
  }
} // namespace deltaform
