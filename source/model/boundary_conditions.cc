#include <deltaform/model/boundary_conditions.h>

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
    Component read_component(Section &section)
    {
      const std::string component = section.choice("Component",
                                                   "z",
                                                   {"r", "z", "rotation"},
                                                   "Direction (plane strain: r is x), or rotation (counterclockwise; a "
                                                   "moment, for loads).");
      return component == "r" ? Component::r : (component == "z" ? Component::z : Component::rotation);
    }

    std::string read_boundary(Section &section, const Blank &blank)
    {
      const auto parts = blank.boundary().parts();
      return section.choice("Boundary", parts.front(), parts, "Part of the boundary.");
    }

    void check_dofs(Section &section, const std::string &boundary, const std::vector<DofIndex> &dofs)
    {
      if (dofs.empty())
        section.fail("Component",
                     "boundary '" + boundary +
                       "' has no such unknown: a solid has no rotations, it is clamped by holding r and z of an edge");
    }

    std::map<std::string, double> constants_at(const Blank &blank, const Point2 &X)
    {
      return {{"thickness", blank.initial_thickness()}, {"R", X[0]}, {"Z", X[1]}};
    }
  } // namespace


  Support::Support(const std::string &support_name, Section section, const Blank &blank)
    : name(support_name), boundary(read_boundary(section, blank)), component(read_component(section)),
      value(
        section.function("Value",
                         Default<std::string>("0"),
                         "length or rad",
                         "Displacement (rotation) from the initial position as a function of time t, of thickness, and "
                         "of the initial place R, Z.",
                         constants_at(blank, blank.boundary().points(boundary).front()))),
      hold(section.flag("Hold", false, "Instead of Value: keep what the unknown has reached when the stage begins.")),
      stages(section.names("Stages",
                           "",
                           "Stages in which the support acts (empty: all). It is released gradually in the next."))
  {
    renumber(blank);
    check_dofs(section, boundary, dofs);
  }


  void Support::renumber(const Blank &blank)
  {
    dofs = blank.boundary().dofs(boundary, component);
    values.clear();
    const auto &text = value.text();
    if (text.find('R') == std::string::npos && text.find('Z') == std::string::npos)
      return;
    for (const auto &X : blank.boundary().points(boundary))
      values.emplace_back(text, constants_at(blank, X));
  }


  bool Support::acts_in(const std::string &stage) const
  {
    return listed(stages, stage);
  }


  Load::Load(const std::string &load_name, Section section, const Blank &blank)
    : name(load_name), kind(Kind::pressure), value(0.)
  {
    const std::string what = section.choice(
      "Kind",
      "pressure",
      {"pressure", "dead pressure", "edge", "body"},
      "Pressure that follows the surface, pressure on the initial area and direction, force or moment on "
      "an edge (solid: traction on the initial area), or force per initial volume.");
    if (what == "edge")
    {
      kind = Kind::edge;
      boundary = read_boundary(section, blank);
      component = read_component(section);
      renumber(blank);
      check_dofs(section, boundary, dofs);
      if (!(*std::max_element(weights.begin(), weights.end()) > 0))
        section.fail("Boundary", "this edge has no length (it lies on the axis): a line load on it is no load");
    }
    else if (what == "body")
    {
      kind = Kind::body;
      component = read_component(section);
      renumber(blank);
      if (dofs.empty())
        section.fail("Component", "a body load is a force, along r or z");
    }
    else
    {
      kind = what == "pressure" ? Kind::pressure : Kind::dead_pressure;
      const auto faces = blank.boundary().faces();
      face = section.choice("Face", faces.front(), faces, "What a pressure acts on (shell: the bottom).");
    }
    value = section.function(
      "Value",
      required("0"),
      "stress, force/length of the initial edge, moment/length, or force/volume",
      "Load as a function of time t. A pressure is positive if it pushes into the blank (bottom: upwards on a flat "
      "blank).",
      {{"thickness", blank.initial_thickness()}});
    stages =
      section.names("Stages", "", "Stages in which the load acts (empty: all). It is released gradually in the next.");
  }


  void Load::renumber(const Blank &blank)
  {
    if (kind == Kind::edge)
    {
      dofs = blank.boundary().dofs(boundary, component);
      weights = blank.boundary().weights(boundary);
    }
    if (kind != Kind::body)
      return;
    dofs.clear();
    weights.clear();
    for (const auto &[dof, weight] : blank.boundary().volume_weights(component))
    {
      dofs.push_back(dof);
      weights.push_back(weight);
    }
  }


  bool Load::acts_in(const std::string &stage) const
  {
    return listed(stages, stage);
  }


  void Load::assemble(const Blank &blank, const Vector &q, const double time, AssemblyTarget &target) const
  {
    const double now = value(time);
    if (!face.empty())
    {
      blank.boundary().assemble_pressure(q, face, now, kind == Kind::pressure, target);
      return;
    }
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      const double residual = -now * weights[i], zero = 0.;
      target.add(&dofs[i], 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
  }
} // namespace deltaform
