#pragma once

#include <deltaform/parameters/scene_file.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// One entry of a scene as the program declares it.
  struct Declaration
  {
    std::string name;
    std::string value; ///< default, or an example if required
    bool required = false;
    std::string unit; ///< dimension; empty where there is none
    std::string allowed; ///< "(0, inf)", "one of a, b"; empty for free text
    std::string sentence;
    std::function<void(const std::string &)> check; ///< throws std::invalid_argument if a value is not allowed
  };

  /// A section with what has been declared in it, in the order of the declarations.
  struct DeclaredSection
  {
    std::string name; ///< empty: the outermost level
    std::string sentence; ///< what it stands for, of a choice: "K (e0 + e)^n"; empty: nothing is said
    std::vector<Declaration> entries;
    std::vector<std::unique_ptr<DeclaredSection>> sections;

    /// Null: there is none.
    const Declaration *entry(const std::string &entry_name) const;
    const DeclaredSection *section(const std::string &section_name) const;
    const DeclaredSection *find(const SectionPath &path) const;

    /// The section at @p path below this one, made if it is not there.
    DeclaredSection &make(const SectionPath &path);

    /// Call @p action for this section and all below it, in the order of the declarations. @param path of this one
    void visit(const SectionPath &path,
               const std::function<void(const DeclaredSection &, const SectionPath &)> &action) const;
  };

  /// @p path, and @p name below it.
  SectionPath below(SectionPath path, const std::string &name);

  /// Declare an entry at its first mention; later ones have to say the same.
  void declare(DeclaredSection &section, const SectionPath &path, const Declaration &declaration);
} // namespace deltaform
