#pragma once
// Names that entries had before; private to the reading of scenes.
#include <deltaform/parameters/scene_file.h>

namespace deltaform
{
  /// Give entries that go by the name of an earlier version their name. Of a file that states both, the old one is
  /// unknown.
  void rename_old_entries(SceneFile &scene);
} // namespace deltaform
