#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Lets deal.II's handler judge values as the declaration does.
    class CheckedPattern : public dealii::Patterns::PatternBase
    {
    public:
      explicit CheckedPattern(const ParameterTree::Declaration &declaration)
        : allowed_(declaration.allowed), check_(declaration.check)
      {
      }

      bool match(const std::string &value) const override
      {
        try
        {
          check_(value);
          return true;
        }
        catch (const std::invalid_argument &)
        {
          return false;
        }
      }

      std::string description(const OutputStyle) const override
      {
        return allowed_;
      }

      std::unique_ptr<PatternBase> clone() const override
      {
        return std::make_unique<CheckedPattern>(*this);
      }

    private:
      std::string allowed_;
      std::function<void(const std::string &)> check_;
    };

    /// What only the author of a declaration can get wrong.
    void check_declaration(const SectionPath &path, const ParameterTree::Declaration &declaration)
    {
      const std::string who = "The declaration of '" + to_string(path, declaration.name) + "' ";
      AssertThrow(declaration.name.find_first_of("/=#\n") == std::string::npos,
                  dealii::ExcMessage(who + "has one of the characters / = # in its name."));
      AssertThrow(declaration.value.find_first_of("#\n") == std::string::npos,
                  dealii::ExcMessage(who + "has a default that is not one line, or contains '#'."));
      try
      {
        declaration.check(declaration.value);
      }
      catch (const std::invalid_argument &error)
      {
        AssertThrow(
          false, dealii::ExcMessage(who + "has the default '" + declaration.value + "', which " + error.what() + "."));
      }
    }
  } // namespace

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
    return ParameterTree(std::move(scene), false);
  }

  ParameterTree
  ParameterTree::parse(const std::string &text, const std::string &name, const std::vector<std::string> &overrides)
  {
    SceneFile scene = SceneFile::parse(text, name);
    for (const auto &assignment : overrides)
      scene.override_entry(assignment);
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
    Node &section = node(path);
    if (const Declaration *const earlier = section.entry(declaration.name))
    {
      AssertThrow(earlier->value == declaration.value && earlier->required == declaration.required &&
                    earlier->unit == declaration.unit && earlier->allowed == declaration.allowed,
                  dealii::ExcMessage("'" + to_string(path, declaration.name) + "' is declared in two ways."));
    }
    else
    {
      check_declaration(path, declaration);
      for (const auto &name : path)
        handler_.enter_subsection(name);
      handler_.declare_entry(declaration.name,
                             declaration.value,
                             CheckedPattern(declaration),
                             declaration.sentence,
                             declaration.required && !documentation_);
      for (std::size_t i = 0; i < path.size(); ++i)
        handler_.leave_subsection();
      section.entries.push_back(declaration);
    }
    if (declaration.required && !documentation_ && !given(path, declaration.name))
      fail_missing(path, declaration);
    return value(path, declaration);
  }

  void ParameterTree::declare_section(const SectionPath &path)
  {
    node(path);
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

  const ParameterTree::Declaration *ParameterTree::Node::entry(const std::string &entry_name) const
  {
    for (const auto &candidate : entries)
      if (candidate.name == entry_name)
        return &candidate;
    return nullptr;
  }

  const ParameterTree::Node *ParameterTree::Node::section(const std::string &section_name) const
  {
    for (const auto &candidate : sections)
      if (candidate->name == section_name)
        return candidate.get();
    return nullptr;
  }

  ParameterTree::Node &ParameterTree::node(const SectionPath &path)
  {
    Node *node = &root_;
    for (const auto &name : path)
    {
      const auto same_name = [&name](const std::unique_ptr<Node> &candidate) { return candidate->name == name; };
      auto next = std::find_if(node->sections.begin(), node->sections.end(), same_name);
      if (next == node->sections.end())
      {
        node->sections.push_back(std::make_unique<Node>());
        next = std::prev(node->sections.end());
        (*next)->name = name;
      }
      node = next->get();
    }
    return *node;
  }

  const ParameterTree::Node *ParameterTree::find(const SectionPath &path) const
  {
    const Node *node = &root_;
    for (const auto &name : path)
      if (node != nullptr)
        node = node->section(name);
    return node;
  }
} // namespace deltaform
