// What a ParameterTree says about a scene that is wrong.
#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>

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
     * @param value_of of an entry of the section
     * @return what to do, or nothing
     */
    template <typename Node>
    std::string missing_in_list(const Node &section,
                                const SectionPath &path,
                                const std::string &unknown,
                                const std::function<std::string(const std::string &)> &value_of)
    {
      for (const std::string list : {"Names", "Stages"})
      {
        if (section.entry(list) == nullptr)
          continue;
        const auto names = text::split(text::unquoted(value_of(list)), ',');
        const bool all = std::all_of(
          names.begin(), names.end(), [&](const std::string &name) { return section.section(name) != nullptr; });
        if (list == "Names" || (all && !names.empty()))
          return "subsection '" + unknown + "' is not in " + to_string(path, list) +
                 (names.empty() ? ", which is empty" : " = " + text::join(names, ", ")) +
                 ": add it there or remove the subsection.";
      }
      return "";
    }
  } // namespace

  void ParameterTree::fail(const SectionPath &path, const std::string &entry, const std::string &message) const
  {
    const std::string who = to_string(path, entry);
    if (const auto *const given = scene_.find(path, entry))
    {
      constexpr std::size_t most = 200;
      const std::string value =
        given->value.size() <= most ? given->value : text::printable(given->value.substr(0, most)) + "...";
      throw SceneError(given->origin.to_string() + ": " + who + " = " + value + ": " + message);
    }

    SectionPath inner = path;
    inner.push_back(entry);
    std::string where = scene_.name;
    for (const auto &place : {inner, path})
      if (const auto *const subsection = scene_.find(place))
      {
        where = subsection->origin.to_string();
        break;
      }
    const Node *const section = find(path);
    const Declaration *const declaration = section == nullptr ? nullptr : section->entry(entry);
    const std::string value = declaration == nullptr ? "" : " = " + declaration->value + " (the default)";
    throw SceneError(where + ": " + who + value + ": " + message);
  }

  void ParameterTree::fail_missing(const SectionPath &path, const Declaration &declaration) const
  {
    std::string message = scene_.name + ": " + to_string(path, declaration.name) + " is required";
    message += declaration.sentence.empty() ? ": add" : " (" + declaration.sentence + "): add";
    message += " 'set " + declaration.name + " = ...', for example " + declaration.value;
    if (!declaration.unit.empty())
      message += " [" + declaration.unit + "]";
    if (!declaration.allowed.empty())
      message += ", " + declaration.allowed;
    message += ", to " + section_title(path);
    if (const auto *const subsection = scene_.find(path))
      message += subsection->origin.file == scene_.name ? " (line " + std::to_string(subsection->origin.line) + ")"
                                                        : " (" + subsection->origin.to_string() + ")";
    else if (!path.empty())
      message += ", which the scene does not have";
    message += ".";

    // Most missing entries are there, misspelt or in another section.
    const Node *const section = find(path);
    for (const auto &entry : scene_.entries)
    {
      const bool misspelt =
        entry.path == path && section->entry(entry.name) == nullptr && text::similar(entry.name, declaration.name);
      const Node *const there = find(entry.path);
      const bool misplaced = entry.path != path && entry.name == declaration.name && path.size() < 2 &&
                             (there == nullptr || there->entry(entry.name) == nullptr);
      if (misspelt || misplaced)
        message += " Is it meant by " + to_string(entry.path, entry.name) + " (" + entry.origin.to_string() + ")?";
    }
    throw SceneError(message);
  }

  std::string ParameterTree::complain_about(const SceneFile::Entry &entry) const
  {
    const std::string opening = entry.origin.to_string() + ": unknown entry " + to_string(entry.path, entry.name);
    SectionPath known_path = entry.path;
    while (find(known_path) == nullptr)
      known_path.pop_back();
    const Node &section = *find(known_path);
    if (known_path.size() < entry.path.size()) // only --set gets here without its subsection being complained about
    {
      std::vector<std::string> known;
      for (const auto &candidate : section.sections)
        known.push_back(candidate->name);
      const std::string &unknown = entry.path[known_path.size()];
      const std::string missing = missing_in_list(
        section, known_path, unknown, [&](const std::string &list) { return value(known_path, *section.entry(list)); });
      if (!missing.empty())
        return opening + ": " + missing;
      return opening + ": there is no subsection '" + unknown + "'." + nearest_known(unknown, known, "subsection");
    }

    std::vector<std::string> known;
    for (const auto &candidate : section.entries)
      known.push_back(candidate.name);
    std::string complaint = opening + "." + nearest_known(entry.name, known, "entry");

    const std::function<void(const Node &, const SectionPath &)> look_for_it =
      [&](const Node &there, const SectionPath &path) {
        if (const Declaration *const same = there.entry(entry.name))
          complaint += " Wrong section? '" + same->name + "' belongs to " + section_title(path) + ".";
        for (const auto &inner : there.sections)
        {
          SectionPath inner_path = path;
          inner_path.push_back(inner->name);
          look_for_it(*inner, inner_path);
        }
      };
    look_for_it(root_, {});
    return complaint;
  }

  std::string ParameterTree::complain_about(const SceneFile::Subsection &subsection) const
  {
    SectionPath parent_path = subsection.path;
    parent_path.pop_back();
    const Node *const parent = find(parent_path);
    if (parent == nullptr) // the parent has been complained about
      return {};
    std::vector<std::string> known;
    for (const auto &candidate : parent->sections)
      known.push_back(candidate->name);
    const std::string opening = subsection.origin.to_string() + ": unknown subsection " + to_string(subsection.path);
    const std::string missing =
      missing_in_list(*parent,
                      parent_path,
                      subsection.path.back(),
                      [&](const std::string &list) { return value(parent_path, *parent->entry(list)); });
    if (!missing.empty())
      return opening + ": " + missing;
    return opening + "." + nearest_known(subsection.path.back(), known, "subsection");
  }

  void ParameterTree::check_unused()
  {
    std::vector<std::string> complaints;
    for (const auto &subsection : scene_.subsections)
      if (find(subsection.path) == nullptr)
        complaints.push_back(complain_about(subsection));
    for (const auto &entry : scene_.entries)
    {
      const Node *const section = find(entry.path);
      const bool known = section != nullptr && section->entry(entry.name) != nullptr;
      const bool covered = section == nullptr && scene_.find(entry.path) != nullptr;
      if (!known && !covered)
        complaints.push_back(complain_about(entry));
    }
    complaints.erase(std::remove(complaints.begin(), complaints.end(), std::string()), complaints.end());
    if (const std::size_t n = complaints.size(); n > ceilings::complaints)
    {
      complaints.resize(ceilings::complaints);
      complaints.push_back("... and " + std::to_string(n - ceilings::complaints) + " more.");
    }
    if (!complaints.empty())
      throw SceneError(text::join(complaints, "\n"));

    // Belt and braces: deal.II's own strict reading of the same.
    for (const auto &entry : scene_.entries)
    {
      for (const auto &name : entry.path)
        handler_.enter_subsection(name);
      handler_.set(entry.name, entry.value);
      for (std::size_t i = 0; i < entry.path.size(); ++i)
        handler_.leave_subsection();
    }
    handler_.assert_that_entries_have_been_set();
  }
} // namespace deltaform
