#include <deltaform/loads/boundary_entries.h>
#include <deltaform/loads/support.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    std::map<std::string, double> constants_at(const Blank &blank, const Point2 &X)
    {
      return {{"thickness", blank.initial_thickness()}, {"R", X[0]}, {"Z", X[1]}};
    }
  } // namespace


  Support::Support(const std::string &support_name, Section section, const Blank &blank)
    : name(support_name), boundary(read_boundary(section, blank.boundary())), component(read_component(section)),
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
                           "Stages in which the support acts (empty: all). Release of the next says how it ends."))
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
} // namespace deltaform
