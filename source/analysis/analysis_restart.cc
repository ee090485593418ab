// The state of an analysis, and going on from it.
#include <deltaform/analysis/analysis.h>
#include <deltaform/base/byte_stream.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/base/text.h>
#include <deltaform/model/accepted_increment.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>

namespace deltaform
{
  Checkpoint Analysis::checkpoint() const
  {
    Checkpoint result;
    result.scene = settings_.entries;
    result.increment = n_increments_;
    result.time = time_;
    result.stage = stage_;
    ByteStream own, others;
    {
      const bool go_on = step_.has_value();
      const auto step = step_.value_or(StepControl::State());
      boost::archive::binary_oarchive archive(own.stream());
      archive << last_increment_ << since_refinement_ << accepted_iterations_ << before_ << go_on << step.increment
              << step.quiet << step.shortened << step.error;
      for (const auto &condition : conditions_)
        condition->save(archive);
    }
    problem_.save(own.stream());
    result.simulation = own.take();
    {
      boost::archive::binary_oarchive archive(others.stream());
      for (const auto &observer : observers_)
        observer->save(archive);
    }
    result.observers = others.take();
    return result;
  }


  void Analysis::resume(const Checkpoint &start)
  {
    const auto &stages = actors_.stages;
    if (start.stage >= stages.size() || start.time < stages[start.stage].begin || start.time > stages[start.stage].end)
      throw SceneError("Cannot resume: the saved state at time " + text::format(start.time) + " is in stage number " +
                       std::to_string(start.stage + 1) + ", which the scene now has " +
                       (start.stage < stages.size() ? "from time " + text::format(stages[start.stage].begin) + " to " +
                                                        text::format(stages[start.stage].end)
                                                    : "no more") +
                       " (Steps). Start again without --resume.");
    time_ = start.time;
    n_increments_ = start.increment;
    stage_ = start.stage;
    std::istringstream own(start.simulation);
    {
      bool go_on = false;
      StepControl::State step;
      boost::archive::binary_iarchive archive(own);
      archive >> last_increment_ >> since_refinement_ >> total_iterations_ >> before_ >> go_on >> step.increment >>
        step.quiet >> step.shortened >> step.error;
      for (const auto &condition : conditions_)
        condition->load(archive);
      if (go_on)
        step_ = step;
    }
    accepted_iterations_ = total_iterations_;
    problem_.load(own);
    resumed_ = true;
    problem_.resume_stage(stage());
    std::istringstream others(start.observers);
    boost::archive::binary_iarchive archive(others);
    for (const auto &observer : observers_)
      observer->load(archive);
    const AcceptedIncrement last = accepted(IncrementCost());
    for (const auto &observer : observers_)
      observer->resumed(last);
  }
} // namespace deltaform
