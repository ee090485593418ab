#include <deltaform/parameters/text.h>
#include <deltaform/parameters/unknown_entries.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// "Blank", or what the outermost level is called in messages.
    std::string section_title(const SectionPath &path)
    {
      return path.empty() ? "the outermost level" : "subsection " + to_string(path);
    }

    std::string nearest_known(const std::string &name, const std::vector<std::string> &known, const std::string &kind)
    {
      if (known.empty())
        return " There is no " + kind + " here.";
      return " The nearest known " + kind + " here is '" + text::nearest(name, known) + "'.";
    }

    /**
     * Is @p unknown left out of the entry that lists the subsections of @p section? "Names", or "Stages", where they
     * are called so: an entry that merely mentions names (the stages of a tool) has no such subsections.
     * @return what to do, or nothing
     */
    std::string missing_in_list(const SceneFile &scene,
                                const DeclaredSection &section,
                                const SectionPath &path,
                                const std::string &unknown)
    {
      for (const std::string list : {"Names", "Stages"})
      {
        const Declaration *const declared = section.entry(list);
        if (declared == nullptr)
          continue;
        const auto *const given = scene.find(path, list);
        const auto names = text::split(text::unquoted(given == nullptr ? declared->value : given->value), ',');
        const bool all = std::all_of(
          names.begin(), names.end(), [&](const std::string &name) { return section.section(name) != nullptr; });
        if (list == "Names" || (all && !names.empty()))
          return "subsection '" + unknown + "' is not in " + to_string(path, list) +
                 (names.empty() ? ", which is empty" : " = " + text::join(names, ", ")) +
                 ": add it there or remove the subsection.";
      }
      return "";
    }

    std::vector<std::string> names_of(const std::vector<std::unique_ptr<DeclaredSection>> &sections)
    {
      std::vector<std::string> result;
      for (const auto &section : sections)
        result.push_back(section->name);
      return result;
    }

    /// Other sections that have an entry of this name.
    std::string other_homes(const DeclaredSection &declared, const std::string &name)
    {
      std::string result;
      declared.visit({}, [&](const DeclaredSection &section, const SectionPath &path) {
        if (section.entry(name) != nullptr)
          result += " Wrong section? '" + name + "' belongs to " + section_title(path) + ".";
      });
      return result;
    }

    std::string
    about(const SceneFile &scene, const DeclaredSection &declared, const SceneFile::Entry &entry)
    {
      const std::string opening = entry.origin.to_string() + ": unknown entry " + to_string(entry.path, entry.name);
      SectionPath known_path = entry.path;
      while (declared.find(known_path) == nullptr)
        known_path.pop_back();
      const DeclaredSection &section = *declared.find(known_path);
      if (known_path.size() < entry.path.size()) // only --set gets here without its subsection being complained about
      {
        const std::string &unknown = entry.path[known_path.size()];
        const std::string missing = missing_in_list(scene, section, known_path, unknown);
        if (!missing.empty())
          return opening + ": " + missing;
        return opening + ": there is no subsection '" + unknown + "'." +
               nearest_known(unknown, names_of(section.sections), "subsection");
      }
      std::vector<std::string> known;
      for (const auto &candidate : section.entries)
        known.push_back(candidate.name);
      return opening + "." + nearest_known(entry.name, known, "entry") + other_homes(declared, entry.name);
    }

    /// Empty: its parent is unknown, and has been complained about.
    std::string
    about(const SceneFile &scene, const DeclaredSection &declared, const SceneFile::Subsection &subsection)
    {
      SectionPath parent_path = subsection.path;
      parent_path.pop_back();
      const DeclaredSection *const parent = declared.find(parent_path);
      if (parent == nullptr)
        return {};
      const std::string &unknown = subsection.path.back();
      const std::string opening = subsection.origin.to_string() + ": unknown subsection " + to_string(subsection.path);
      const std::string missing = missing_in_list(scene, *parent, parent_path, unknown);
      if (!missing.empty())
        return opening + ": " + missing;
      return opening + "." + nearest_known(unknown, names_of(parent->sections), "subsection");
    }
  } // namespace


  std::vector<std::string> unknown_entries(const SceneFile &scene, const DeclaredSection &declared)
  {
    std::vector<std::string> result;
    for (const auto &subsection : scene.subsections)
      if (declared.find(subsection.path) == nullptr)
        result.push_back(about(scene, declared, subsection));
    for (const auto &entry : scene.entries)
    {
      const DeclaredSection *const section = declared.find(entry.path);
      const bool known = section != nullptr && section->entry(entry.name) != nullptr;
      const bool covered = section == nullptr && scene.find(entry.path) != nullptr;
      if (!known && !covered)
        result.push_back(about(scene, declared, entry));
    }
    result.erase(std::remove(result.begin(), result.end(), std::string()), result.end());
    return result;
  }


  std::string missing_entry(const SceneFile &scene,
                            const DeclaredSection &declared,
                            const SectionPath &path,
                            const Declaration &declaration)
  {
    std::string message = scene.name + ": " + to_string(path, declaration.name) + " is required";
    message += declaration.sentence.empty() ? ": add" : " (" + declaration.sentence + "): add";
    message += " 'set " + declaration.name + " = ...', for example " + declaration.value;
    if (!declaration.unit.empty())
      message += " [" + declaration.unit + "]";
    if (!declaration.allowed.empty())
      message += ", " + declaration.allowed;
    message += ", to " + section_title(path);
    if (const auto *const subsection = scene.find(path))
      message += subsection->origin.file == scene.name ? " (line " + std::to_string(subsection->origin.line) + ")"
                                                       : " (" + subsection->origin.to_string() + ")";
    else if (!path.empty())
      message += ", which the scene does not have";
    message += ".";

    // Most missing entries are there, misspelt or in another section.
    const DeclaredSection *const section = declared.find(path);
    for (const auto &entry : scene.entries)
    {
      const bool misspelt =
        entry.path == path && section->entry(entry.name) == nullptr && text::similar(entry.name, declaration.name);
      const DeclaredSection *const there = declared.find(entry.path);
      const bool misplaced = entry.path != path && entry.name == declaration.name && path.size() < 2 &&
                             (there == nullptr || there->entry(entry.name) == nullptr);
      if (misspelt || misplaced)
        message += " Is it meant by " + to_string(entry.path, entry.name) + " (" + entry.origin.to_string() + ")?";
    }
    return message;
  }
} // namespace deltaform
