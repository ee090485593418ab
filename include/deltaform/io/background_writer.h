#pragma once

#include <deque>
#include <functional>
#include <future>

namespace deltaform
{
  /**
   * Writes files while the computation goes on: one task at a time, in the order in which they come. A few of them may
   * wait, so that a disk that falters does not hold up the computation. A task must own all it needs and call nothing
   * of MPI. On the processes that write no files tasks are dropped.
   */
  class BackgroundWriter
  {
  public:
    /// Do @p task when those before are done. @throws what one of them has thrown; those after it are not done
    void run(std::function<void()> task);

    /// Until all tasks are done. @throws what one of them has thrown
    void wait();

  private:
    static constexpr std::size_t most = 4; ///< tasks in hand: what they own is in memory

    std::deque<std::shared_future<void>> tasks_; ///< the destructor of each waits
  };
} // namespace deltaform
