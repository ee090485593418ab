#include <deltaform/io/background_writer.h>
#include <deltaform/process/ranks.h>

#include <chrono>
#include <utility>

namespace deltaform
{
  void BackgroundWriter::run(std::function<void()> task)
  {
    if (!ranks::first())
      return;
    const auto done = [](const auto &first) {
      return first.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    while (!tasks_.empty() && (tasks_.size() >= most || done(tasks_.front())))
    {
      tasks_.front().get();
      tasks_.pop_front();
    }
    auto follow =
      [before = tasks_.empty() ? std::shared_future<void>() : tasks_.back(), task = std::move(task)]() mutable {
        // Moved out, or every task would keep the one before for ever.
        if (const auto previous = std::move(before); previous.valid())
          previous.get();
        task();
      };
    // Where no thread is to be had, tasks are done in wait().
    tasks_.push_back(std::async(std::launch::async | std::launch::deferred, std::move(follow)));
  }


  void BackgroundWriter::wait()
  {
    for (; !tasks_.empty(); tasks_.pop_front())
      tasks_.front().get();
  }
} // namespace deltaform
