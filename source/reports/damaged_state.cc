#include <deltaform/reports/checkpoint.h>
#include <deltaform/reports/damaged_state.h>

#include <deal.II/base/exceptions.h>

#include <new>
#include <stdexcept>

namespace deltaform
{
  std::string damaged_state(const std::string &folder, const std::exception &error)
  {
    // Those of deal.II are pages for its developers.
    std::string reason = dynamic_cast<const dealii::ExceptionBase *>(&error) == nullptr ? error.what() : "";
    if (dynamic_cast<const std::bad_alloc *>(&error) != nullptr ||
        dynamic_cast<const std::length_error *>(&error) != nullptr ||
        dynamic_cast<const dealii::StandardExceptions::ExcOutOfMemory *>(&error) != nullptr)
      reason = "a length in it is more than memory holds";
    return Checkpoint::damaged(folder) + (reason.empty() ? "" : " (" + reason + ")");
  }
} // namespace deltaform
