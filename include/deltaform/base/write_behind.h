#pragma once

#include <functional>
#include <future>

namespace deltaform
{
  /**
   * Writes files while the computation goes on: one task at a time, in the order in which they come, each in a thread
   * of its own. A task must own all it needs and call nothing of MPI. On the processes that write no files tasks are
   * dropped.
   */
  class WriteBehind
  {
  public:
    /// Start @p task as soon as the one before is done. @throws what the one before has thrown
    void run(std::function<void()> task);

    /// Until the last task is done. @throws what it has thrown
    void wait();

  private:
    std::future<void> task_; ///< its destructor waits
  };
} // namespace deltaform
