#include <deltaform/assembly/collector.h>
#include <deltaform/blanks/refinement.h>

#include <deltaform/loads/boundary_entries.h>
#include <deltaform/loads/load.h>
#include <deltaform/loads/load_way.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    /// @param way what may be prescribed instead of the load; empty: nothing
    std::string read_control(Section &section, const std::string &way)
    {
      if (way.empty())
        return section.choice("Control", "load", {"load"}, "What Value is: the load itself.");
      const std::string what =
        way == "volume"
          ? "volume: what the face has swept since the start (length^3; plane strain: length^2). "
          : "displacement: the mean displacement (rad for a rotation) of what is loaded. ";
      return section.choice("Control",
                            "load",
                            {"load", way, "arc length"},
                            "What Value is. load: the load itself. " + what +
                              "arc length: the length of the path, the displacements' root mean square over all nodes "
                              "added up; it grows where load and displacement pass a maximum. The load then follows "
                              "from equilibrium.");
    }
  } // namespace


  Load::Load(Section &section, const Blank &blank, const LoadWords &words)
    : name_(section.title()),
      value_(section.function("Value", required("0"), words.unit, words.sentence,
                              {{"thickness", blank.initial_thickness()}})),
      is_mean_(words.way != "volume")
  {
    const std::string control = read_control(section, words.way);
    follows_way_ = control != "load";
    stages_ =
      section.names("Stages", "", "Stages in which the load acts (empty: all). Release of the next says how it ends.");
    if (control != "arc length")
      return;
    if (blank.adaptive() != nullptr && blank.adaptive()->settings().asked_for)
      section.fail("Control", "the nodes of a path stay the same: no arc length with Blank/Refinement");
    path_.emplace(blank);
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


  Status Load::assemble(const Vector &q, const double time, AssemblyTarget &target) const
  {
    add(q, size(q, time), target);
    if (tool_unknown_ != invalid_index)
    {
      const double residual = lift(time), zero = 0.;
      target.add(&tool_unknown_, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
    if (path_)
      path_->assemble(*this, q, skipped_.value(value_, time), target);
    else if (follows_way_)
      LoadWay(*this, q).assemble(skipped_.value(value_, time) * (is_mean_ ? unit_force(q.size()) : 1.), target);
    return {};
  }
} // namespace deltaform
