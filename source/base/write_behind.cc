#include <deltaform/base/ranks.h>
#include <deltaform/base/write_behind.h>

#include <utility>

namespace deltaform
{
  void WriteBehind::run(std::function<void()> task)
  {
    wait();
    if (ranks::first())
      task_ = std::async(std::launch::async, std::move(task));
  }


  void WriteBehind::wait()
  {
    if (task_.valid())
      task_.get();
  }
} // namespace deltaform
