#include <deltaform/analysis/conditions.h>

#include <map>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    std::map<std::string, ConditionEntry::Maker> &makers()
    {
      static std::map<std::string, ConditionEntry::Maker> all;
      return all;
    }
  } // namespace


  ConditionEntry::ConditionEntry(const std::string &name, const Maker make)
  {
    if (!makers().emplace(name, make).second)
      throw std::logic_error("two conditions are called '" + name + "'");
  }


  std::vector<std::unique_ptr<Condition>> make_conditions(const Actors &actors)
  {
    std::vector<std::unique_ptr<Condition>> result;
    for (const auto &entry : makers())
      result.push_back(entry.second(actors));
    return result;
  }
} // namespace deltaform
