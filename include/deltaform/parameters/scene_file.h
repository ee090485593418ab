#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /// Where a statement of the scene stands. Line 0: not in a file, but in @p file = "--set".
  struct Origin
  {
    std::string file;
    unsigned int line = 0;

    std::string to_string() const; ///< "scene.prm:12" or "--set"
  };

  /// Names of the nested subsections, outermost first.
  using SectionPath = std::vector<std::string>;

  /// "Tools/punch".
  std::string to_string(const SectionPath &path);

  /// "Tools/punch/Friction coefficient".
  std::string to_string(const SectionPath &path, const std::string &entry);

  /**
   * What a scene says, before anybody knows which entries exist: every `set` and every `subsection` with its place.
   * The language is that of deal.II's ParameterHandler:
   *
   *     # comment
   *     include common.prm        (relative to the file in which it stands; may stand inside a subsection)
   *     subsection Blank
   *       set Thickness = 0.035   # a trailing backslash continues a line
   *     end
   */
  struct SceneFile
  {
    struct Entry
    {
      SectionPath path;
      std::string name;
      std::string value;
      Origin origin;
      int layer = 0; ///< what was said later has a higher one: -1 taken from a table, 0 the file, 1, 2, ... --set
    };

    struct Subsection
    {
      SectionPath path;
      Origin origin;
    };

    std::string name; ///< the file as the user called it
    std::vector<Entry> entries; ///< in order; an entry that replaces an included one appears once
    std::vector<Subsection> subsections; ///< in order, each path once, where it first begins
    int n_overrides = 0; ///< assignments of the command line

    /**
     * Read a file and what it includes. An entry of the including file and one of the included file may have the same
     * name: the later one counts.
     * @throws SceneError with file and line: unreadable file, include that is missing or closes a cycle, line that is
     * no statement, unmatched end, subsection without end, entry stated twice in one file.
     */
    static SceneFile read(const std::string &file_name);

    /// The same for a text that is not in a file; includes are relative to the working folder.
    static SceneFile parse(const std::string &text, const std::string &name);

    /// Add "A/B/entry=value" of the command line, which replaces what the file says. @throws SceneError
    void override_entry(const std::string &assignment);

    /// Add an entry of a table, which replaces nothing.
    void supply(Entry entry);

    const Entry *find(const SectionPath &path, const std::string &entry) const;
    const Subsection *find(const SectionPath &path) const;
  };
} // namespace deltaform
