// The solid as read, and what it tells solver and scene about itself; set-up, assembly and results have their own
// files.
#include "solid.h"


#include <deltaform/base/ranks.h>
#include <deltaform/base/registry.h>
#include <deltaform/base/text.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  Solid::Solid(Section &section)
    : degree_(section.integer("Degree", 1, 1, 2, "Polynomial degree: 1 for bulk forming, 2 where a thin blank bends.")),
      axisymmetric_(section.choice("Symmetry",
                                   "axisymmetric",
                                   {"axisymmetric", "plane strain"},
                                   "Axisymmetric about r = 0 (forces for the full circumference) or plane strain (per "
                                   "unit width).") == "axisymmetric"),
      finite_(
        section.choice("Kinematics",
                       "finite",
                       {"finite", "small"},
                       "Finite strain, or displacements so small that the undeformed body serves for equilibrium.") ==
        "finite"),
      refinement_(section.sub("Refinement")), space_(section, degree_, axisymmetric_), points_(space_),
      boundary_(space_), faces_{{SolidFace(space_), SolidFace(space_)}}
  {
    auto bottom =
      section.names("Contact bottom",
                    "bottom",
                    "Parts of the boundary that tools with Side = bottom touch; 'bottom, end' goes around the "
                    "corner.");
    auto top = section.names("Contact top", "top", "Parts of the boundary that tools with Side = top touch.");
    material_ = MaterialPoints(section, ThirdDirection::strain_given, axisymmetric_);
    if (section.documentation() && space_.mesh().boundaries().empty())
      return;

    space_.set_up();
    for (const auto &X : space_.nodes())
      if (space_.axisymmetric() && X[0] < -1e-9 * space_.mesh().thickness())
        section.fail("Symmetry",
                     "an axisymmetric body must lie at r >= 0: a node is at r = " + text::format(X[0]) +
                       ", z = " + text::format(X[1]));
    for (const auto &X : space_.nodes())
      outermost_ = std::max(outermost_, X[0]);
    points_.set_up();
    set_up_state();
    std::vector<unsigned int> bad; // a node of the first bad cell of each process
    for (unsigned int p = 0; p < points_.size() && bad.empty(); ++p)
      if (!(points_[p].weight > 0))
        bad.push_back(space_.cells()[p / points_.per_cell()][0]);
    for (const auto node : ranks::gather(bad))
      section.fail(
        space_.mesh().is_strip() ? "Thickness" : "File",
        "the cell near r = " + text::format(space_.nodes()[node][0]) +
          ", z = " + text::format(space_.nodes()[node][1]) +
          " is turned inside out: the strip is thicker than its meridian is curved, or the mesh is clockwise");
    boundary_.set_up();
    for (const auto &[names, entry, face] :
         {std::tuple(bottom, "Contact bottom", 0), std::tuple(top, "Contact top", 1)})
      for (const auto &name : names)
        if (boundary_.has(name))
          contact_boundaries_[face].push_back(name);
        else if (section.given(entry) || space_.mesh().is_strip())
          section.fail(entry,
                       "there is no boundary '" + name + "'; there are " +
                         text::join(space_.mesh().boundaries(), ", "));
    for (unsigned int side = 0; side < 2; ++side)
      faces_[side].set_up(boundary_, contact_boundaries_[side]);
    shortest_edge_ = std::min(faces_[0].shortest_edge(), faces_[1].shortest_edge());
    if (!std::isfinite(shortest_edge_))
      shortest_edge_ = space_.mesh().thickness();
    for (auto &face : faces_)
      face.set_up_areas(shortest_edge_);
    update_thickness(Vector(n_dofs()));
    update_places(Vector(n_dofs()));
  }


  unsigned int Solid::n_dofs() const
  {
    return space_.hanging().n_unknowns();
  }


  dealii::IndexSet Solid::locally_owned_dofs() const
  {
    return space_.hanging().owned();
  }


  void Solid::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    space_.add_couplings(pattern);
  }


  std::vector<DofIndex> Solid::fixed_dofs() const
  {
    return space_.axis_dofs();
  }


  std::vector<std::string> Solid::boundaries() const
  {
    return space_.mesh().boundaries();
  }


  std::vector<std::string> Solid::faces() const
  {
    return space_.mesh().boundaries();
  }


  std::vector<DofIndex> Solid::boundary_dofs(const std::string &boundary, const Component component) const
  {
    std::vector<DofIndex> result;
    for (const auto node : boundary_.nodes(boundary))
      if (component != Component::rotation)
        result.push_back(space_.dofs()[node][static_cast<unsigned int>(component)]);
    return result;
  }


  std::vector<Point2> Solid::boundary_points(const std::string &boundary) const
  {
    std::vector<Point2> result;
    for (const auto node : boundary_.nodes(boundary))
      result.push_back(space_.nodes()[node]);
    return result;
  }


  std::vector<double> Solid::boundary_weights(const std::string &boundary) const
  {
    return boundary_.weights(boundary);
  }


  std::vector<std::pair<DofIndex, double>> Solid::volume_weights(const Component component) const
  {
    if (component == Component::rotation)
      return {};
    return points_.volume_weights(static_cast<unsigned int>(component));
  }


  void Solid::assemble_pressure(const Vector &q,
                                const std::string &face,
                                const double pressure,
                                const bool following,
                                AssemblyTarget &target) const
  {
    boundary_.assemble_pressure(q, face, pressure, following && finite_, target);
  }


  unsigned int Solid::n_contact_nodes(const Side side) const
  {
    return faces_[static_cast<unsigned int>(side)].nodes().size();
  }


  const std::vector<std::array<unsigned int, 3>> &Solid::contact_edges(const Side side) const
  {
    return faces_[static_cast<unsigned int>(side)].edges();
  }


  void Solid::contact_node(const Vector &q,
                           const Side side,
                           const unsigned int node,
                           ContactThickness,
                           ContactNode &result) const
  {
    faces_[static_cast<unsigned int>(side)].contact_node(q, node, result);
    result.thickness = shortest_edge_;
  }


  std::vector<Point2> Solid::positions(const Vector &q) const
  {
    return space_.positions(q);
  }


  void Solid::rigid_motion(const Vector &q,
                           const Tensor1 &translation,
                           const double rotation,
                           const std::function<void(DofIndex, double)> &set) const
  {
    space_.rigid_motion(q, translation, rotation, set);
  }


  unsigned int Solid::n_cells() const
  {
    return space_.mesh().n_cells();
  }


  double Solid::estimated_error() const
  {
    return estimated_error_;
  }


  double Solid::dof_scale(const DofIndex) const
  {
    return 1.;
  }


  std::string Solid::describe_dof(const DofIndex dof) const
  {
    return space_.describe(dof);
  }


  double Solid::initial_flow_stress() const
  {
    const std::vector<double> history(material_.law().history_size(), 0.);
    return material_.law().flow_stress(history.data());
  }


  double Solid::stiffness_scale() const
  {
    // Of a node of cells that are about as long as high: E (per unit width), times the radius of the ring it stands
    // for.
    return material_.law().young_modulus() * (space_.axisymmetric() ? outermost_ : 1.);
  }


  double Solid::modulus() const
  {
    return material_.law().young_modulus();
  }


  bool Solid::constant_stiffness() const
  {
    return linear_;
  }


  bool Solid::axisymmetric() const
  {
    return space_.axisymmetric();
  }


  double Solid::initial_thickness() const
  {
    return space_.mesh().thickness();
  }


  double Solid::typical_length() const
  {
    return shortest_edge_;
  }


  static const Registry<Blank>::Entry
    entry("solid",
          "solid of quadrilaterals, axisymmetric or plane strain: finite or small strain",
          &make_as<Solid, Blank>);
} // namespace deltaform
