// What a recorder needs to go on with the files of a run that was interrupted.
#include "recorder_files.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/set.hpp>
#include <boost/serialization/string.hpp>

#include <sstream>
#include <utility>

namespace deltaform
{
  void Recorder::resume(const FormingProblem &problem, const Checkpoint &start)
  {
    std::istringstream stream(start.recorder);
    boost::archive::binary_iarchive archive(stream);
    archive >> *files_;
    // Other numbers of pictures or stages that end later may be asked for now.
    const auto &frames = files_->scene.output->frame_times;
    files_->next_frame = 0;
    while (files_->next_frame < frames.size() && start.time >= frames[files_->next_frame] * (1 - 1e-12))
      ++files_->next_frame;
    files_->pictures.resume(files_->last_picture);
    files_->n_pictures = files_->pictures.size();
    if (start.increment > 0)
      files_->last =
        files_->row(problem, files_->scene.actors.stages[start.stage], start.time, start.increment, IncrementCost());
  }


  bool Recorder::checkpoint_due() const
  {
    return files_->timers.total() - files_->saved_at >= files_->scene.output->checkpoint_interval;
  }


  std::string Recorder::state() const
  {
    std::ostringstream stream;
    {
      boost::archive::binary_oarchive archive(stream);
      archive << static_cast<const Files &>(*files_);
    }
    return stream.str();
  }


  void Recorder::save(Checkpoint state)
  {
    Timers::Scope scope(files_->timers, files_->timer);
    // After the pictures that it counts on.
    files_->behind.run([state = std::move(state), folder = files_->folder]() { state.write(folder); });
    files_->saved_at = files_->timers.total();
  }


  void Recorder::complete()
  {
    Timers::Scope scope(files_->timers, files_->timer);
    files_->behind.wait();
  }
} // namespace deltaform
