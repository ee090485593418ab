#include <deltaform/parameters/declared_section.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// What only the author of a declaration can get wrong.
    void check(const SectionPath &path, const Declaration &declaration)
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


  const Declaration *DeclaredSection::entry(const std::string &entry_name) const
  {
    for (const auto &candidate : entries)
      if (candidate.name == entry_name)
        return &candidate;
    return nullptr;
  }


  const DeclaredSection *DeclaredSection::section(const std::string &section_name) const
  {
    for (const auto &candidate : sections)
      if (candidate->name == section_name)
        return candidate.get();
    return nullptr;
  }


  const DeclaredSection *DeclaredSection::find(const SectionPath &path) const
  {
    const DeclaredSection *there = this;
    for (const auto &part : path)
      if (there != nullptr)
        there = there->section(part);
    return there;
  }


  DeclaredSection &DeclaredSection::make(const SectionPath &path)
  {
    DeclaredSection *there = this;
    for (const auto &part : path)
    {
      const auto same_name = [&part](const auto &candidate) { return candidate->name == part; };
      auto next = std::find_if(there->sections.begin(), there->sections.end(), same_name);
      if (next == there->sections.end())
      {
        there->sections.push_back(std::make_unique<DeclaredSection>());
        next = std::prev(there->sections.end());
        (*next)->name = part;
      }
      there = next->get();
    }
    return *there;
  }


  void DeclaredSection::visit(const SectionPath &path,
                              const std::function<void(const DeclaredSection &, const SectionPath &)> &action) const
  {
    action(*this, path);
    for (const auto &inner : sections)
      inner->visit(below(path, inner->name), action);
  }


  SectionPath below(SectionPath path, const std::string &name)
  {
    path.push_back(name);
    return path;
  }


  void declare(DeclaredSection &section, const SectionPath &path, const Declaration &declaration)
  {
    if (const Declaration *const earlier = section.entry(declaration.name))
    {
      AssertThrow(earlier->value == declaration.value && earlier->required == declaration.required &&
                    earlier->unit == declaration.unit && earlier->allowed == declaration.allowed,
                  dealii::ExcMessage("'" + to_string(path, declaration.name) + "' is declared in two ways."));
      return;
    }
    check(path, declaration);
    section.entries.push_back(declaration);
  }
} // namespace deltaform
