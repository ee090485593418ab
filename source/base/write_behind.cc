#include <deltaform/base/ranks.h>
#include <deltaform/base/write_behind.h>

#include <utility>

namespace deltaform
{
  void WriteBehind::run(std::function<void()> task)
  {
    wait();
    if (ranks::first())
      task_ = std::async(std::launch::async | std::launch::deferred,
                         std::move(task)); // where no thread is to be had: in wait()
  }


  void WriteBehind::wait()
  {
    if (task_.valid())
      task_.get();
  }
} // namespace deltaform
