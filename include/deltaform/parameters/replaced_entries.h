#pragma once

#include <deltaform/parameters/declared_section.h>
#include <deltaform/parameters/scene_file.h>

#include <functional>
#include <string>
#include <vector>

namespace deltaform
{
  /// Would an entry (a section, if the name is empty) be known with other choices than those of the scene?
  using KnownElsewhere = std::function<bool(const SectionPath &, const std::string &)>;

  /**
   * Take out of a scene the entries that a later choice has left without a meaning, such as the constants of a law that
   * --set has replaced by another. A misspelt entry is none of them. @return a sentence about each
   */
  std::vector<std::string>
  drop_replaced(SceneFile &scene, const DeclaredSection &root, const KnownElsewhere &known_elsewhere);
} // namespace deltaform
