#include <deltaform/app/explain.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/text.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <ostream>
#include <set>

namespace deltaform
{
  namespace
  {
    using Documented = ParameterTree::Documented;

    /// Is it the name of a choice ("Shape: die") rather than of a section?
    bool is_choice(const std::string &part)
    {
      return part.find(": ") != std::string::npos;
    }

    /// Where an entry stands in a scene.
    SectionPath place(const Documented &one)
    {
      SectionPath result;
      for (std::size_t i = 0; i < one.path.size(); ++i)
        if (!is_choice(one.path[i]))
          result.push_back(i == 1 && one.path[0] == "Steps" ? "<name>" : one.path[i]); // stages have names
      return result;
    }

    /// Capitals do not count; what has a name of its own goes with any.
    bool same(const std::string &part, const std::string &asked)
    {
      return part == "<name>" || text::edit_distance(part, asked) == 0;
    }

    bool matches(const Documented &one, const std::vector<std::string> &asked)
    {
      if (!same(one.entry.name, asked.back()))
        return false;
      const SectionPath path = place(one);
      return asked.size() == 1 ||
             (path.size() + 1 == asked.size() && std::equal(path.begin(), path.end(), asked.begin(), same));
    }

    std::string choices(const Documented &one)
    {
      std::vector<std::string> result;
      std::copy_if(one.path.begin(), one.path.end(), std::back_inserter(result), is_choice);
      return text::join(result, ", ");
    }

    void print(const Documented &one, std::ostream &out)
    {
      const auto &entry = one.entry;
      out << to_string(place(one), entry.name);
      if (const std::string with = choices(one); !with.empty())
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
    auto tree = ParameterTree::documentation();
    declare_everything(tree);
    const auto all = tree.documented();
    const auto asked = text::split(entry, '/');
    if (asked.empty())
      throw UsageError("explain needs the name of an entry, for example \"Tools/punch/Friction coefficient\".");
    std::set<std::string> told; // choices repeat what they have in common
    for (const auto &one : all)
      if (matches(one, asked) && told.insert(to_string(place(one), one.entry.name) + one.entry.sentence).second)
        print(one, out);
    if (!told.empty())
    {
      out << "Every entry: doc/parameters.md, or deltaform --print-parameters\n";
      return;
    }
    std::vector<std::string> names;
    for (const auto &one : all)
    {
      names.push_back(one.entry.name);
      names.push_back(to_string(place(one), one.entry.name));
    }
    throw UsageError("There is no entry '" + entry + "'; the nearest known one is '" + text::nearest(entry, names) +
                     "'.");
  }
} // namespace deltaform
