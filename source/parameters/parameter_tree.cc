#include "renamed_entries.h"

#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/parameter_pages.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/parameters/unknown_entries.h>

namespace deltaform
{
  ParameterTree::ParameterTree(SceneFile scene)
    : ParameterTree(std::move(scene), false)
  {
  }

  ParameterTree::ParameterTree(SceneFile scene, const bool documentation)
    : scene_(std::move(scene)), documentation_(documentation)
  {
  }

  ParameterTree ParameterTree::read(const std::string &file_name, const std::vector<std::string> &overrides)
  {
    SceneFile scene = SceneFile::read(file_name);
    for (const auto &assignment : overrides)
      scene.override_entry(assignment);
    rename_old_entries(scene);
    return ParameterTree(std::move(scene), false);
  }

  ParameterTree
  ParameterTree::parse(const std::string &text, const std::string &name, const std::vector<std::string> &overrides)
  {
    SceneFile scene = SceneFile::parse(text, name);
    for (const auto &assignment : overrides)
      scene.override_entry(assignment);
    rename_old_entries(scene);
    return ParameterTree(std::move(scene), false);
  }

  ParameterTree ParameterTree::documentation()
  {
    SceneFile scene;
    scene.name = "documentation";
    return ParameterTree(std::move(scene), true);
  }

  Section ParameterTree::root()
  {
    return Section(*this, {});
  }

  const std::string &ParameterTree::file_name() const
  {
    return scene_.name;
  }

  std::string ParameterTree::declare(const SectionPath &path, const Declaration &declaration)
  {
    deltaform::declare(root_.make(path), path, declaration);
    if (declaration.required && !documentation_ && !given(path, declaration.name))
      throw SceneError(missing_entry(scene_, root_, path, declaration));
    return value(path, declaration);
  }

  void ParameterTree::describe(const SectionPath &path, const std::string &sentence)
  {
    root_.make(path).sentence = sentence;
  }

  void ParameterTree::declare_section(const SectionPath &path)
  {
    root_.make(path);
  }

  bool ParameterTree::given(const SectionPath &path, const std::string &entry) const
  {
    return scene_.find(path, entry) != nullptr;
  }

  bool ParameterTree::is_documentation() const
  {
    return documentation_;
  }

  std::string ParameterTree::value(const SectionPath &path, const Declaration &declaration) const
  {
    const auto *const given = scene_.find(path, declaration.name);
    return given == nullptr ? declaration.value : given->value;
  }

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

    std::string where = scene_.name;
    for (const auto &place : {below(path, entry), path})
      if (const auto *const subsection = scene_.find(place))
      {
        where = subsection->origin.to_string();
        break;
      }
    const DeclaredSection *const section = root_.find(path);
    const Declaration *const declaration = section == nullptr ? nullptr : section->entry(entry);
    const std::string value = declaration == nullptr ? "" : " = " + declaration->value + " (the default)";
    throw SceneError(where + ": " + who + value + ": " + message);
  }

  void ParameterTree::supply(const SceneFile::Entry &entry)
  {
    scene_.supply(entry);
  }

  std::string ParameterTree::stated(const SectionPath &path, const std::string &entry) const
  {
    const auto *const said = scene_.find(path, entry);
    return said == nullptr ? "" : said->value;
  }

  std::vector<std::string> ParameterTree::drop_replaced(const KnownElsewhere &known_elsewhere)
  {
    return deltaform::drop_replaced(scene_, root_, known_elsewhere);
  }

  void ParameterTree::check_unused()
  {
    std::vector<std::string> complaints = unknown_entries(scene_, root_);
    if (const std::size_t n = complaints.size(); n > ceilings::complaints)
    {
      complaints.resize(ceilings::complaints);
      complaints.push_back("... and " + std::to_string(n - ceilings::complaints) + " more.");
    }
    if (!complaints.empty())
      throw SceneError(text::join(complaints, "\n"));
  }

  void ParameterTree::print_prm(std::ostream &out) const
  {
    deltaform::print_prm(out, root_, {}, [this](const SectionPath &path, const Declaration &entry) {
      return value(path, entry);
    });
  }

  std::vector<ParameterTree::Value> ParameterTree::values() const
  {
    std::vector<Value> result;
    root_.visit({}, [&](const DeclaredSection &section, const SectionPath &path) {
      for (const auto &entry : section.entries)
        result.push_back({path, entry.name, value(path, entry)});
    });
    return result;
  }

  std::vector<ParameterTree::Documented> ParameterTree::documented() const
  {
    std::vector<Documented> result;
    root_.visit({}, [&](const DeclaredSection &section, const SectionPath &path) {
      for (const auto &entry : section.entries)
        result.push_back({path, entry});
    });
    return result;
  }

  void ParameterTree::print_markdown(std::ostream &out) const
  {
    deltaform::print_markdown(out, root_);
  }
} // namespace deltaform
