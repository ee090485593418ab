#include "renamed_entries.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace deltaform
{
  namespace
  {
    /// @p section is the outermost one.
    struct Renamed
    {
      const char *section, *before, *now, *until; ///< the first version that does not know the old name
    };

    const std::vector<Renamed> names = {{"Tools", "Squeeze", "Thickness compliance", "0.3"}};
  } // namespace


  void rename_old_entries(SceneFile &scene)
  {
    for (const auto &renamed : names)
      for (auto entry = scene.entries.begin(); entry != scene.entries.end(); ++entry)
      {
        if (entry->name != renamed.before || entry->path.empty() || entry->path.front() != renamed.section)
          continue;
        const auto same = std::find_if(scene.entries.begin(), scene.entries.end(), [&](const SceneFile::Entry &other) {
          return other.path == entry->path && other.name == renamed.now;
        });
        if (same == scene.entries.end())
          entry->name = renamed.now;
        else if (entry->layer > same->layer) // --set over a file that knows the name
        {
          SceneFile::Entry later = *entry;
          later.name = renamed.now;
          *same = later;
          entry = std::prev(scene.entries.erase(entry));
        }
      }
  }
} // namespace deltaform
