#include <deltaform/parameters/text.h>
#include <deltaform/scene/known_entries.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <iterator>

namespace deltaform
{
  namespace
  {
    using Documented = ParameterTree::Documented;

    bool is_choice(const std::string &part)
    {
      return part.find(": ") != std::string::npos;
    }

    std::vector<Documented> documented()
    {
      auto tree = ParameterTree::documentation();
      declare_everything(tree);
      return tree.documented();
    }
  } // namespace


  KnownEntries::KnownEntries()
    : all_(documented())
  {
  }


  SectionPath KnownEntries::place(const Documented &entry)
  {
    SectionPath result;
    for (std::size_t i = 0; i < entry.path.size(); ++i)
      if (!is_choice(entry.path[i]))
        result.push_back(i == 1 && entry.path[0] == "Steps" ? "<name>" : entry.path[i]); // stages have names
    return result;
  }


  std::vector<std::string> KnownEntries::choices(const Documented &entry)
  {
    std::vector<std::string> result;
    std::copy_if(entry.path.begin(), entry.path.end(), std::back_inserter(result), is_choice);
    return result;
  }


  bool KnownEntries::same(const std::string &part, const std::string &asked)
  {
    return part == "<name>" || text::edit_distance(part, asked) == 0;
  }


  bool KnownEntries::contain(const SectionPath &path, const std::string &name) const
  {
    return std::any_of(all_.begin(), all_.end(), [&](const Documented &one) {
      const SectionPath own = place(one);
      const bool here = name.empty() ? own.size() >= path.size() : own.size() == path.size() && one.entry.name == name;
      return here && std::equal(path.begin(), path.end(), own.begin(), [](const auto &asked, const auto &part) {
               return part == "<name>" || part == asked;
             });
    });
  }
} // namespace deltaform
