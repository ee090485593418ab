#pragma once

#include <deltaform/parameters/declared_section.h>
#include <deltaform/parameters/magnitudes.h>
#include <deltaform/parameters/replaced_entries.h>
#include <deltaform/parameters/scene_file.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * All parameters of a run: what the scene says and what the objects of the program have declared. While objects are
   * made, each declares its entries through a Section and gets their values at once (lenient pass: nobody knows yet
   * what else will be declared); when all are made, check_unused() names what is left in the scene. Objects of this
   * class stay where they are, because sections point to them.
   */
  class ParameterTree
  {
  public:
    explicit ParameterTree(SceneFile scene);
    ParameterTree(const ParameterTree &) = delete;
    ParameterTree &operator=(const ParameterTree &) = delete;

    /// Read a scene; @p overrides are "A/B/entry=value". @throws SceneError
    static ParameterTree read(const std::string &file_name, const std::vector<std::string> &overrides = {});

    /// The same for a text, called @p name in messages.
    static ParameterTree
    parse(const std::string &text, const std::string &name, const std::vector<std::string> &overrides = {});

    /// A tree without a scene, in which required entries have their example values: everything that is registered can
    /// be made from it.
    static ParameterTree documentation();

    Section root();

    /// The scene file as the user called it.
    const std::string &file_name() const;

    /// Add an entry that counts where the scene itself says nothing.
    void supply(const SceneFile::Entry &entry);

    /// What the scene says of an entry, before anybody has declared it; empty if nothing.
    std::string stated(const SectionPath &path, const std::string &entry) const;

    /// After everything has been made: deltaform::drop_replaced().
    std::vector<std::string> drop_replaced(const KnownElsewhere &known_elsewhere);

    /**
     * The strict pass, after everything has been made: @throws SceneError if the scene has entries or subsections that
     * nobody declared, naming all of them with their lines and the nearest known ones.
     */
    void check_unused();

    /**
     * The scene as read, completed by every default: a scene again, which reads back to the same values. Each entry
     * comes with unit, range and sentence as a comment.
     */
    void print_prm(std::ostream &out) const;

    /// An entry and its value, as print_prm() writes them.
    struct Value
    {
      SectionPath path;
      std::string name, text;
    };

    /// All entries, in the order of print_prm().
    std::vector<Value> values() const;

    /// An entry as it is declared, and where; a choice stands in its path as "Shape: die".
    struct Documented
    {
      SectionPath path;
      Declaration entry;
    };

    /// All entries that were declared, in the order of print_markdown().
    std::vector<Documented> documented() const;

    /// Say what the choice stands for whose entries are documented under @p path ("Law: swift").
    void describe(const SectionPath &path, const std::string &sentence);

    /// One table per section: entry, default, unit, allowed values, sentence.
    void print_markdown(std::ostream &out) const;

    /// @name For Section
    /// @{

    /// Declare an entry, at its first mention, and return the text of its value. @throws SceneError if it is required
    /// and missing.
    std::string declare(const SectionPath &path, const Declaration &declaration);

    /// Make a section known, so that it may stand in the scene even if it stays empty.
    void declare_section(const SectionPath &path);

    bool given(const SectionPath &path, const std::string &entry) const;
    bool is_documentation() const;

    /// Throw a SceneError that opens with file, line, entry and value.
    [[noreturn]] void fail(const SectionPath &path, const std::string &entry, const std::string &message) const;

    Magnitudes &magnitudes()
    {
      return magnitudes_;
    }

    /// @}

  private:
    ParameterTree(SceneFile scene, bool documentation);

    std::string value(const SectionPath &path, const Declaration &declaration) const;

    SceneFile scene_;
    Magnitudes magnitudes_; ///< of the numbers read so far
    bool documentation_ = false;
    DeclaredSection root_;
  };
} // namespace deltaform
