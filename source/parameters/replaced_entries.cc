#include <deltaform/parameters/replaced_entries.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// Is @p inner the section @p outer, or inside of it?
    bool within(const SectionPath &inner, const SectionPath &outer)
    {
      return outer.size() <= inner.size() && std::equal(outer.begin(), outer.end(), inner.begin());
    }
  } // namespace


  std::vector<std::string>
  drop_replaced(SceneFile &scene, const DeclaredSection &root, const KnownElsewhere &known_elsewhere)
  {
    const auto declared = [&root](const SectionPath &path, const std::string &name) -> const Declaration * {
      const DeclaredSection *const section = root.find(path);
      return section == nullptr ? nullptr : section->entry(name);
    };
    // The choice in @p path, or else the nearest one around it, that was made after everything of a layer.
    const auto choice_after = [&](const int layer, const SectionPath &path) {
      const SceneFile::Entry *nearest = nullptr;
      for (const auto &later : scene.entries)
      {
        const Declaration *const own = declared(later.path, later.name);
        if (later.layer > layer && within(path, later.path) && own != nullptr && own->allowed.rfind("one of", 0) == 0 &&
            (nearest == nullptr || later.path.size() > nearest->path.size()))
          nearest = &later;
      }
      return nearest;
    };

    std::vector<std::string> notes;
    std::vector<bool> dropped;
    for (const auto &entry : scene.entries)
    {
      const SceneFile::Entry *const choice =
        declared(entry.path, entry.name) != nullptr ? nullptr : choice_after(entry.layer, entry.path);
      dropped.push_back(choice != nullptr && known_elsewhere(entry.path, entry.name));
      if (dropped.back())
        notes.push_back(to_string(entry.path, entry.name) + " = " + entry.value + " (" + entry.origin.to_string() +
                        ") is not used: it does not go with " + to_string(choice->path, choice->name) + " = " +
                        choice->value + " (" + choice->origin.to_string() + ")");
    }
    auto drop = dropped.begin();
    scene.entries.erase(
      std::remove_if(scene.entries.begin(), scene.entries.end(), [&drop](const auto &) { return *drop++; }),
      scene.entries.end());
    const auto without_meaning = [&](const SceneFile::Subsection &subsection) {
      return root.find(subsection.path) == nullptr && choice_after(0, subsection.path) != nullptr &&
             known_elsewhere(subsection.path, "");
    };
    scene.subsections.erase(std::remove_if(scene.subsections.begin(), scene.subsections.end(), without_meaning),
                            scene.subsections.end());
    return notes;
  }
} // namespace deltaform
