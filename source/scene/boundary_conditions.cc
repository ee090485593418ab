#include <deltaform/scene/boundary_conditions.h>

#include <algorithm>
#include <stdexcept>

namespace deltaform
{
  bool listed(const std::vector<std::string> &stages, const std::string &stage)
  {
    return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
  }


  namespace
  {
    std::vector<DofIndex> read_dofs(Section &section, const Blank &blank)
    {
      const std::string boundary =
        section.choice("Boundary", blank.boundaries().front(), blank.boundaries(), "Part of the boundary.");
      const std::string component = section.choice("Component",
                                                   "z",
                                                   {"r", "z", "rotation"},
                                                   "Direction (plane strain: r is x), or rotation (counterclockwise; a "
                                                   "moment, for loads).");
      return blank.boundary_dofs(boundary,
                                 component == "r"   ? Component::r
                                 : component == "z" ? Component::z
                                                    : Component::rotation);
    }
  } // namespace


  Support::Support(const std::string &support_name, Section section, const Blank &blank)
    : name(support_name), dofs(read_dofs(section, blank)),
      value(section.function("Value",
                             Default<std::string>("0"),
                             "length or rad",
                             "Displacement (rotation) from the initial position as a function of time t.",
                             {{"thickness", blank.initial_thickness()}})),
      hold(section.flag("Hold", false, "Instead of Value: keep what the unknown has reached when the stage begins.")),
      stages(section.names("Stages",
                           "",
                           "Stages in which the support acts (empty: all). It is released gradually in the next."))
  {
  }


  bool Support::acts_in(const std::string &stage) const
  {
    return listed(stages, stage);
  }


  Load::Load(const std::string &load_name, Section section, const Blank &blank)
    : name(load_name), kind(Kind::pressure), value(0.)
  {
    const std::string what =
      section.choice("Kind",
                     "pressure",
                     {"pressure", "dead pressure", "edge"},
                     "Pressure that follows the surface, pressure on the initial area and direction, or "
                     "force or moment on an edge.");
    if (what == "edge")
    {
      kind = Kind::edge;
      dofs = read_dofs(section, blank);
      const auto boundary =
        section.choice("Boundary", blank.boundaries().front(), blank.boundaries(), "Part of the boundary.");
      measure = blank.reference_measure(boundary);
      if (!(measure > 0))
        section.fail("Boundary", "this edge has no length (it lies on the axis): a line load on it is no load");
    }
    else if (what == "dead pressure")
      kind = Kind::dead_pressure;
    value = section.function(
      "Value",
      required("0"),
      "stress, force/length of the initial edge, or moment/length",
      "Load as a function of time t. A pressure is positive on the bottom face (upwards on a flat blank).",
      {{"thickness", blank.initial_thickness()}});
    stages =
      section.names("Stages", "", "Stages in which the load acts (empty: all). It is released gradually in the next.");
  }


  bool Load::acts_in(const std::string &stage) const
  {
    return listed(stages, stage);
  }


  void Load::assemble(const Blank &blank, const Vector &q, const double time, AssemblyTarget &target) const
  {
    const double now = value(time);
    if (kind != Kind::edge)
    {
      blank.assemble_pressure(q, now, kind == Kind::pressure, target);
      return;
    }
    for (const auto dof : dofs)
    {
      const double residual = -now * measure, zero = 0.;
      target.add(&dof, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
  }
} // namespace deltaform
