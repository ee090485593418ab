// The solid as read, and what it tells solver and scene about itself; set-up, assembly and results have their own
// files.
#include "solid.h"


#include <deltaform/base/ranks.h>
#include <deltaform/base/registry.h>
#include <deltaform/base/text.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

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
      refinement_(section.sub("Refinement")), mesh_(section, degree_, axisymmetric_),
      dof_handler_(mesh_.triangulation())
  {
    auto bottom =
      section.names("Contact bottom",
                    "bottom",
                    "Parts of the boundary that tools with Side = bottom touch; 'bottom, end' goes around the "
                    "corner.");
    auto top = section.names("Contact top", "top", "Parts of the boundary that tools with Side = top touch.");
    material_ = MaterialPoints(section, ThirdDirection::strain_given);
    if (section.documentation() && mesh_.boundaries().empty())
      return;

    set_up_dofs();
    for (const auto &X : nodes_)
      if (axisymmetric_ && X[0] < -1e-9 * mesh_.thickness())
        section.fail("Symmetry",
                     "an axisymmetric body must lie at r >= 0: a node is at r = " + text::format(X[0]) +
                       ", z = " + text::format(X[1]));
    for (const auto &X : nodes_)
      outermost_ = std::max(outermost_, X[0]);
    set_up_points();
    std::vector<unsigned int> bad; // a node of the first bad cell of each process
    for (unsigned int p = 0; p < points_.size() && bad.empty(); ++p)
      if (!(points_[p].weight > 0))
        bad.push_back(cells_[p / n_points_per_cell_][0]);
    for (const auto node : ranks::gather(bad))
      section.fail(
        mesh_.is_strip() ? "Thickness" : "File",
        "the cell near r = " + text::format(nodes_[node][0]) + ", z = " + text::format(nodes_[node][1]) +
          " is turned inside out: the strip is thicker than its meridian is curved, or the mesh is clockwise");
    set_up_boundary();
    for (const auto &[names, entry, face] :
         {std::tuple(bottom, "Contact bottom", 0), std::tuple(top, "Contact top", 1)})
      for (const auto &name : names)
        if (boundary_edges_.count(name) > 0)
          contact_boundaries_[face].push_back(name);
        else if (section.given(entry) || mesh_.is_strip())
          section.fail(entry, "there is no boundary '" + name + "'; there are " + text::join(mesh_.boundaries(), ", "));
    for (unsigned int face = 0; face < 2; ++face)
      set_up_face(faces_[face], contact_boundaries_[face]);
    shortest_edge_ = 1e300;
    for (const auto &face : faces_)
      for (const auto &edge : face.edges)
        shortest_edge_ =
          std::min(shortest_edge_, nodes_[face.nodes[edge[0]]].distance(nodes_[face.nodes[edge[1]]]) / degree_);
    if (shortest_edge_ == 1e300)
      shortest_edge_ = mesh_.thickness();
    set_up_weightless();
    update_thickness(Vector(n_dofs()));
    update_places(Vector(n_dofs()));
  }


  unsigned int Solid::n_dofs() const
  {
    return n_free_;
  }


  dealii::IndexSet Solid::locally_owned_dofs() const
  {
    return owned_;
  }


  void Solid::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    std::vector<DofIndex> dofs;
    for (const auto &cell : cells_)
    {
      dofs.clear();
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
        for (const auto i : node_dofs_[cell[a]])
          if (i < n_free_)
            dofs.push_back(i);
          else
            for (const auto &[master, weight] : hanging_[i - n_free_])
              dofs.push_back(master);
      for (const auto i : dofs)
        for (const auto j : dofs)
          pattern.add(i, j);
    }
  }


  std::vector<DofIndex> Solid::fixed_dofs() const
  {
    std::vector<DofIndex> result;
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      if (axisymmetric_ && std::abs(nodes_[i][0]) < 1e-9 * mesh_.thickness())
        result.push_back(node_dofs_[i][0]);
    return result;
  }


  std::vector<std::string> Solid::boundaries() const
  {
    return mesh_.boundaries();
  }


  std::vector<std::string> Solid::faces() const
  {
    return mesh_.boundaries();
  }


  const std::vector<Solid::Edge> &Solid::edges(const std::string &boundary) const
  {
    const auto found = boundary_edges_.find(boundary);
    if (found == boundary_edges_.end())
      throw std::invalid_argument("this solid has no boundary '" + boundary + "', only " +
                                  text::join(mesh_.boundaries(), ", "));
    return found->second;
  }


  std::vector<unsigned int> Solid::boundary_nodes(const std::string &boundary) const
  {
    std::set<unsigned int> result;
    for (const auto &edge : edges(boundary))
      result.insert(edge.begin(), edge.begin() + degree_ + 1);
    return {result.begin(), result.end()};
  }


  std::vector<DofIndex> Solid::boundary_dofs(const std::string &boundary, const Component component) const
  {
    std::vector<DofIndex> result;
    for (const auto node : boundary_nodes(boundary))
      if (component != Component::rotation)
        result.push_back(node_dofs_[node][static_cast<unsigned int>(component)]);
    return result;
  }


  std::vector<Point2> Solid::boundary_points(const std::string &boundary) const
  {
    std::vector<Point2> result;
    for (const auto node : boundary_nodes(boundary))
      result.push_back(nodes_[node]);
    return result;
  }


  unsigned int Solid::n_cells() const
  {
    return mesh_.n_cells();
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
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      for (unsigned int k = 0; k < 2; ++k)
        if (node_dofs_[i][k] == dof)
          return "node " + std::to_string(i) + " (R0 = " + text::format(nodes_[i][0]) +
                 ", Z0 = " + text::format(nodes_[i][1]) + "), " + (k == 0 ? "u_r" : "u_z");
    return "unknown " + std::to_string(dof);
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
    return material_.law().young_modulus() * (axisymmetric_ ? outermost_ : 1.);
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
    return axisymmetric_;
  }


  double Solid::initial_thickness() const
  {
    return mesh_.thickness();
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
