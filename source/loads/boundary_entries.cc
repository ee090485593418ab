#include <deltaform/loads/boundary_entries.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
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


  std::string read_boundary(Section &section, const Boundary &boundary)
  {
    const auto parts = boundary.parts();
    return section.choice("Boundary", parts.front(), parts, "Part of the blank's boundary.");
  }


  void check_dofs(Section &section, const std::string &boundary, const std::vector<DofIndex> &dofs)
  {
    if (dofs.empty())
      section.fail("Component",
                   "boundary '" + boundary +
                     "' has no such unknown: a solid has no rotations, it is clamped by holding r and z of an edge");
  }


  bool listed(const std::vector<std::string> &stages, const std::string &stage)
  {
    return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
  }
} // namespace deltaform
