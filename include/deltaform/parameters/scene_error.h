#pragma once

#include <stdexcept>
#include <string>

namespace deltaform
{
  /// The scene is wrong: exit status 1. The message names file, line, entry and what to do.
  class SceneError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace deltaform
