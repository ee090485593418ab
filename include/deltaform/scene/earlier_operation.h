#pragma once

#include <deltaform/io/keyed_arrays.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Scene;

  /// A sentence if the folder Start from of a scene has no saved state yet; else empty. @throws SceneError if there is
  /// one that cannot be read
  std::string missing_start(const Scene &scene);

  /// What the user of the folder Start from should know, from its summary.json: the earlier operation did not come to
  /// its end, or ended with warnings. Nothing where there is no such folder.
  std::vector<std::string> doubts_about_start(const Scene &scene);

  /// What the run in the folder Start from of a scene has formed its blank to, from the state that was saved last: see
  /// Blank::formed(). @throws SceneError if there is no such state, or it cannot be read
  KeyedArrays formed_blank(const Scene &scene);
} // namespace deltaform
