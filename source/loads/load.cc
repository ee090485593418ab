#include <deltaform/assembly/collector.h>

#include <deltaform/loads/boundary_entries.h>
#include <deltaform/loads/load.h>
#include <deltaform/loads/load_way.h>

namespace deltaform
{
  Load::Load(Section &section, const Blank &blank, const LoadWords &words)
    : name_(section.title()),
      value_(section.function("Value", required("0"), words.unit, words.sentence,
                              {{"thickness", blank.initial_thickness()}})),
      follows_way_(section.choice("Control", "load",
                                  words.way.empty() ? std::vector<std::string>{"load"}
                                                    : std::vector<std::string>{"load", words.way},
                                  words.way == "volume"
                                    ? "What Value is: the load itself, or the volume that the face has swept since the "
                                      "start (length^3; plane strain: length^2). The load then follows from "
                                      "equilibrium, also past its maximum."
                                    : "What Value is: the load itself, or the mean displacement (rad for a rotation) "
                                      "of what is loaded. The load then follows from equilibrium, also past its "
                                      "maximum.") != "load"),
      is_mean_(words.way != "volume"),
      stages_(section.names(
        "Stages", "", "Stages in which the load acts (empty: all). It is released gradually in the next."))
  {
  }


  bool Load::acts_in(const std::string &stage) const
  {
    return listed(stages_, stage);
  }


  double Load::unit_force(const unsigned int n) const
  {
    Collector forces(n);
    add(Vector(n), 1., forces);
    return forces.residual.l1_norm();
  }


  Status Load::assemble(const Vector &q, const double time, AssemblyTarget &target)
  {
    add(q, size(q, time), target);
    if (tool_unknown_ != invalid_index)
    {
      const double residual = lift(time), zero = 0.;
      target.add(&tool_unknown_, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
    if (follows_way_)
      LoadWay(*this, q).assemble(skipped_.value(value_, time) * (is_mean_ ? unit_force(q.size()) : 1.), target);
    return {};
  }
} // namespace deltaform
