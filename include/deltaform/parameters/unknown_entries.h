#pragma once

#include <deltaform/parameters/declared_section.h>
#include <deltaform/parameters/scene_file.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// What @p scene has that nobody declared: a sentence for each entry and subsection, with its line and the nearest
  /// known name. Empty if all is known.
  std::vector<std::string> unknown_entries(const SceneFile &scene, const DeclaredSection &declared);

  /// The sentence for a required entry that @p scene does not have: where to add it, and entries that may be meant.
  std::string missing_entry(const SceneFile &scene,
                            const DeclaredSection &declared,
                            const SectionPath &path,
                            const Declaration &declaration);
} // namespace deltaform
