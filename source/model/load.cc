#include <deltaform/model/boundary_entries.h>
#include <deltaform/model/load.h>

namespace deltaform
{
  Load::Load(Section &section, const Blank &blank, const std::string &unit, const std::string &sentence)
    : name_(section.title()),
      value_(section.function("Value", required("0"), unit, sentence, {{"thickness", blank.initial_thickness()}})),
      stages_(section.names(
        "Stages", "", "Stages in which the load acts (empty: all). It is released gradually in the next."))
  {
  }


  bool Load::acts_in(const std::string &stage) const
  {
    return listed(stages_, stage);
  }


  Status Load::assemble(const Vector &q, const double time, AssemblyTarget &target)
  {
    add(q, value_(time), target);
    return {};
  }
} // namespace deltaform
