// The state of a simulation, and going on from it.
#include <deltaform/base/byte_stream.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/base/text.h>
#include <deltaform/scene/simulation.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>

namespace deltaform
{
  Checkpoint Simulation::checkpoint() const
  {
    const Timers::Scope timer(timers_, timer_output_);
    Checkpoint result;
    result.scene = Checkpoint::entries(scene_.tree);
    result.increment = increment_;
    result.time = time_;
    result.stage = stage_;
    result.recorder = recorder_.state();
    ByteStream bytes;
    {
      const bool go_on = step_.has_value();
      const auto step = step_.value_or(StepControl::State());
      boost::archive::binary_oarchive archive(bytes.stream());
      archive << last_increment_ << since_refinement_ << accepted_iterations_ << failed_iterations_ << before_ << go_on
              << step.increment << step.quiet << step.shortened << step.error << check_;
    }
    problem_.save(bytes.stream());
    result.simulation = bytes.take();
    return result;
  }


  void Simulation::resume(const Checkpoint &start)
  {
    const auto &stages = scene_.actors.stages;
    if (start.stage >= stages.size() || start.time < stages[start.stage].begin || start.time > stages[start.stage].end)
      throw SceneError("Cannot resume: the saved state at time " + text::format(start.time) + " is in stage number " +
                       std::to_string(start.stage + 1) + ", which the scene now has " +
                       (start.stage < stages.size() ? "from time " + text::format(stages[start.stage].begin) + " to " +
                                                        text::format(stages[start.stage].end)
                                                    : "no more") +
                       " (Steps). Start again without --resume.");
    time_ = start.time;
    increment_ = start.increment;
    stage_ = start.stage;
    std::istringstream stream(start.simulation);
    {
      bool go_on = false;
      StepControl::State step;
      boost::archive::binary_iarchive archive(stream);
      archive >> last_increment_ >> since_refinement_ >> total_iterations_ >> failed_iterations_ >> before_ >> go_on >>
        step.increment >> step.quiet >> step.shortened >> step.error >> check_;
      if (go_on)
        step_ = step;
    }
    accepted_iterations_ = total_iterations_;
    problem_.load(stream);
    resumed_ = true;
    problem_.resume_stage(stages[stage_]);
    recorder_.resume(problem_, start);
  }
} // namespace deltaform
