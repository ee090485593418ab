#pragma once

#include <deltaform/scene/scene.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// What makes a scene doubtful although it can be computed, each with what to do about it; said before the run.
  std::vector<std::string> input_warnings(const Scene &scene);
} // namespace deltaform
