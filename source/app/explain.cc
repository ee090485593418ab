#include <deltaform/app/explain.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/text.h>
#include <deltaform/scene/known_entries.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <set>

namespace deltaform
{
  namespace
  {
    using Documented = ParameterTree::Documented;

    bool matches(const Documented &one, const std::vector<std::string> &asked)
    {
      if (!KnownEntries::same(one.entry.name, asked.back()))
        return false;
      const SectionPath path = KnownEntries::place(one);
      return asked.size() == 1 || (path.size() + 1 == asked.size() &&
                                   std::equal(path.begin(), path.end(), asked.begin(), KnownEntries::same));
    }

    /// The entries of a section, or nothing if there is no such section.
    std::string entries_of(const KnownEntries &known, const std::vector<std::string> &asked)
    {
      std::string result;
      std::set<std::string> told;
      for (const auto &one : known.all())
      {
        const SectionPath path = KnownEntries::place(one);
        if (path.size() == asked.size() && std::equal(path.begin(), path.end(), asked.begin(), KnownEntries::same) &&
            told.insert(one.entry.name).second)
          result += "  " + one.entry.name + '\n';
      }
      return result;
    }

    /// The known name that is most like the one asked for; empty if none is like it.
    std::string likely(const std::vector<std::string> &asked, const std::vector<std::string> &names)
    {
      const std::string nearest = text::nearest(asked.back(), names);
      return text::similar(asked.back(), nearest) ? nearest : "";
    }

    /// Capitals do not count.
    bool contains(const std::string &name, const std::string &word)
    {
      const auto equal = [](const unsigned char a, const unsigned char b) {
        return std::tolower(a) == std::tolower(b);
      };
      return std::search(name.begin(), name.end(), word.begin(), word.end(), equal) != name.end();
    }

    void print(const Documented &one, std::ostream &out)
    {
      const auto &entry = one.entry;
      out << to_string(KnownEntries::place(one), entry.name);
      if (const std::string with = text::join(KnownEntries::choices(one), ", "); !with.empty())
        out << "  (with " << with << ")";
      out << "\n  " << entry.sentence << '\n';
      if (!entry.unit.empty())
        out << "  unit     " << (entry.unit == "1" ? "none, a pure number" : entry.unit) << '\n';
      if (!entry.allowed.empty())
        out << "  allowed  " << entry.allowed << '\n';
      out << (entry.required ? "  required, for example " : "  default  ")
          << (entry.value.empty() ? "empty" : entry.value) << "\n\n";
    }
  } // namespace


  void explain(const std::string &entry, std::ostream &out)
  {
    const KnownEntries known;
    const auto asked = text::split(entry, '/');
    if (asked.empty())
      throw UsageError("explain needs the name of an entry, for example \"Tools/punch/Friction coefficient\".");
    std::set<std::string> told; // choices repeat what they have in common
    for (const auto &one : known.all())
      if (matches(one, asked))
      {
        const std::string name = to_string(KnownEntries::place(one), one.entry.name);
        if (told.insert(name + one.entry.sentence).second)
          print(one, out);
      }
    if (!told.empty())
    {
      out << "Every entry: doc/parameters.md, or deltaform --print-parameters\n";
      return;
    }
    if (const std::string entries = entries_of(known, asked); !entries.empty())
    {
      out << entry << " is a section with the entries\n"
          << entries;
      return;
    }
    std::vector<std::string> names;
    std::set<std::string> containing; // "friction": entries that have the word in their name
    for (const auto &one : known.all())
    {
      const std::string whole = to_string(KnownEntries::place(one), one.entry.name);
      names.push_back(one.entry.name);
      if (contains(one.entry.name, asked.back()))
        containing.insert(whole);
    }
    const std::string nearest = likely(asked, names);
    const std::string others =
      !containing.empty()
        ? "these have the word in their name: " + text::join({containing.begin(), containing.end()}, "; ") + "."
      : !nearest.empty() ? "the nearest known one is '" + nearest + "'."
                         : "deltaform --print-parameters lists all.";
    throw UsageError("There is no entry '" + entry + "'; " + others);
  }
} // namespace deltaform
