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
    std::vector<std::string> names;
    std::set<std::string> containing; // "friction": entries that have the word in their name
    for (const auto &one : known.all())
    {
      const std::string whole = to_string(KnownEntries::place(one), one.entry.name);
      names.push_back(one.entry.name);
      names.push_back(whole);
      if (contains(one.entry.name, asked.back()))
        containing.insert(whole);
    }
    const std::string others =
      containing.empty()
        ? "the nearest known one is '" + text::nearest(entry, names) + "'."
        : "these have the word in their name: " + text::join({containing.begin(), containing.end()}, "; ") + ".";
    throw UsageError("There is no entry '" + entry + "'; " + others);
  }
} // namespace deltaform
