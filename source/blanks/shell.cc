// Set-up of the shell and what it hands to contact and solver; assembly and results stand in files of their own.
#include "shell.h"


#include <deltaform/base/registry.h>
#include <deltaform/kinematics/shell_strain.h>

#include <deal.II/base/quadrature_lib.h>
#include <stdexcept>

namespace deltaform
{
  using dealii::numbers::PI;

  Shell::Shell(Section &section)
    : degree_(section.integer("Degree",
                              1,
                              1,
                              2,
                              "Polynomial degree: 1 with one-point, 2 with two-point reduced integration.")),
      axisymmetric_(
        section.choice("Symmetry",
                       "axisymmetric",
                       {"axisymmetric", "plane strain"},
                       "Axisymmetric about r = 0 (forces for the full circumference) or plane strain (per unit "
                       "width).") == "axisymmetric"),
      membrane_(section.flag("Membrane", false, "No bending: one layer, no rotations. Needs tension to be stable.")),
      transverse_normal_stress_(
        section.flag("Transverse normal stress",
                     true,
                     "Put the mean of the contact pressures of both faces into the yield condition of the layers.")),
      thickness_(
        section.number("Thickness", required(1.), Range::positive(), "length", "Initial thickness of the blank.")),
      shear_factor_(section.number("Shear correction factor",
                                   5. / 6.,
                                   Range::positive(),
                                   "1",
                                   "Factor of the transverse shear stiffness.")),
      n_layers_(section.integer("Layers", 7, 1, 15, "Points through the thickness (membrane: one).")),
      mesh_(section, degree_), triangulation_(dealii::Triangulation<1, 2>::none), dof_handler_(triangulation_)
  {
    const std::string rule =
      section.choice("Layer rule", "gauss", {"gauss", "lobatto"}, "Integration through the thickness.");
    contact_point_ =
      section.choice("Contact point",
                     "normal offset",
                     {"normal offset", "outer fibre"},
                     "Where a node touches: half a thickness away along the tool's normal, or on the outer "
                     "fibre along the director (the force then has a moment).") == "normal offset"
        ? ContactPoint::normal_offset
        : ContactPoint::outer_fibre;

    material_ = MaterialPoints(section, ThirdDirection::stress_given, axisymmetric_);

    if (membrane_)
      n_layers_ = 1;
    else if (n_layers_ < 2)
      section.fail("Layers", "one layer has no bending stiffness: set Membrane = true, or use at least 2");
    if (membrane_ && contact_point_ == ContactPoint::outer_fibre)
      section.fail("Contact point", "a membrane has no director: use 'normal offset'");
    for (const auto &X : mesh_.nodes())
      if (axisymmetric_ && X[0] < 0)
        section.fail("Points", "an axisymmetric meridian must lie at r >= 0");

    const dealii::Quadrature<1> layers = rule == "gauss" || n_layers_ < 2
                                           ? dealii::Quadrature<1>(dealii::QGauss<1>(n_layers_))
                                           : dealii::Quadrature<1>(dealii::QGaussLobatto<1>(n_layers_));
    for (unsigned int l = 0; l < n_layers_; ++l)
    {
      layer_position_.push_back(thickness_ * (layers.point(l)[0] - .5));
      layer_weight_.push_back(thickness_ * layers.weight(l));
    }
    set_up_dofs();
    set_up_points();
    set_up_nodes();
  }


  void Shell::update_areas(const Vector &q) const
  {
    const double factor = axisymmetric_ ? 2 * PI : 1.;
    std::fill(node_area_.begin(), node_area_.end(), 0.);
    for (const auto &cell : mesh_.cells())
    {
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a <= degree_; ++a)
        x[a] = position(q, cell.nodes[a]);
      for (const auto &[shape, gradient, weight] : load_quadrature_)
      {
        Tensor1 x_xi;
        double r = 0;
        for (unsigned int a = 0; a <= degree_; ++a)
        {
          x_xi += gradient[a] * x[a];
          r += shape[a] * x[a][0];
        }
        const double dA = factor * (axisymmetric_ ? r : 1.) * x_xi.norm() * weight;
        for (unsigned int a = 0; a <= degree_; ++a)
          node_area_[cell.nodes[a]] += shape[a] * dA;
      }
    }
    // The weight of a node on the axis vanishes for degree 2 in the initial configuration: it has no contact.
    for (unsigned int i = 0; i < node_area_.size(); ++i)
      if (weightless_[i])
        node_area_[i] = 0.;
  }


  unsigned int Shell::n_dofs() const
  {
    return dof_handler_.n_dofs();
  }


  void Shell::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &cell : mesh_.cells())
      for (unsigned int a = 0; a <= degree_; ++a)
        for (unsigned int b = 0; b <= degree_; ++b)
          for (const auto i : node_dofs_[cell.nodes[a]])
            for (const auto j : node_dofs_[cell.nodes[b]])
              pattern.add(i, j);
  }


  std::vector<DofIndex> Shell::fixed_dofs() const
  {
    std::vector<DofIndex> result;
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
    {
      const bool on_axis = axisymmetric_ && mesh_.nodes()[i][0] < 1e-12 * thickness_;
      if (on_axis)
        result.push_back(node_dofs_[i][0]);
      if (on_axis || membrane_)
        result.push_back(node_dofs_[i][2]);
    }
    return result;
  }


  std::vector<std::string> Shell::boundaries() const
  {
    return {"start", "end"};
  }


  std::vector<DofIndex> Shell::boundary_dofs(const std::string &boundary, const Component component) const
  {
    const unsigned int k = static_cast<unsigned int>(component);
    if (boundary == "start")
      return {node_dofs_.front()[k]};
    if (boundary == "end")
      return {node_dofs_.back()[k]};
    throw std::invalid_argument("a shell has no boundary '" + boundary + "', only 'start' and 'end'");
  }


  std::vector<Point2> Shell::boundary_points(const std::string &boundary) const
  {
    return {boundary == "start" ? mesh_.nodes().front() : mesh_.nodes().back()};
  }


  std::vector<double> Shell::boundary_weights(const std::string &boundary) const
  {
    return {axisymmetric_ ? 2 * PI * boundary_points(boundary).front()[0] : 1.};
  }


  std::vector<std::string> Shell::faces() const
  {
    return {"bottom"};
  }


  std::vector<std::pair<DofIndex, double>> Shell::volume_weights(const Component component) const
  {
    if (component == Component::rotation)
      return {};
    // The areas are those of the configuration that is assembled: ask for the initial ones, then go back to them.
    const auto now = node_area_;
    update_areas(Vector(n_dofs()));
    std::vector<std::pair<DofIndex, double>> result;
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
      result.emplace_back(node_dofs_[i][static_cast<unsigned int>(component)], thickness_ * node_area_[i]);
    node_area_ = now;
    return result;
  }


  double Shell::dof_scale(const DofIndex dof) const
  {
    return is_rotation_[dof] ? thickness_ : 1.;
  }


  double Shell::initial_flow_stress() const
  {
    const std::vector<double> history(material_.law().history_size(), 0.);
    return material_.law().flow_stress(history.data());
  }


  double Shell::stiffness_scale() const
  {
    return material_.law().young_modulus() * thickness_;
  }


  unsigned int Shell::n_cells() const
  {
    return mesh_.cells().size();
  }


  bool Shell::axisymmetric() const
  {
    return axisymmetric_;
  }


  double Shell::initial_thickness() const
  {
    return thickness_;
  }


  double Shell::typical_length() const
  {
    return thickness_;
  }


  Point2 Shell::position(const Vector &q, const unsigned int node) const
  {
    return mesh_.nodes()[node] + Tensor1({q[node_dofs_[node][0]], q[node_dofs_[node][1]]});
  }


  double Shell::rotation(const Vector &q, const unsigned int node) const
  {
    return q[node_dofs_[node][2]];
  }


  double Shell::admissible_step(const Vector &q, const Vector &dq) const
  {
    constexpr double largest_stretch = .3, largest_rotation = .3;
    double factor = 1.;
    for (const auto &cell : mesh_.cells())
    {
      const auto a = cell.nodes[0], b = cell.nodes[1];
      const double length = (position(q, b) - position(q, a)).norm();
      const Tensor1 du({dq[node_dofs_[b][0]] - dq[node_dofs_[a][0]], dq[node_dofs_[b][1]] - dq[node_dofs_[a][1]]});
      factor = std::min(factor, largest_stretch * length / std::max(du.norm(), 1e-300));
      if (axisymmetric_)
        factor = std::min(factor,
                          largest_stretch * std::max(position(q, b)[0], length) /
                            std::max(std::abs(dq[node_dofs_[b][0]]), 1e-300));
    }
    for (const auto &dofs : node_dofs_)
      factor = std::min(factor, largest_rotation / std::max(std::abs(dq[dofs[2]]), 1e-300));
    return factor;
  }


  unsigned int Shell::n_contact_nodes(Side) const
  {
    return node_dofs_.size();
  }


  const std::vector<std::array<unsigned int, 3>> &Shell::contact_edges(Side) const
  {
    return edges_;
  }


  void Shell::contact_node(const Vector &q,
                           const Side side,
                           const unsigned int node,
                           const ContactThickness thickness,
                           ContactNode &result) const
  {
    const double h = thickness == ContactThickness::current   ? node_thickness_[node]
                     : thickness == ContactThickness::initial ? thickness_
                                                              : 0.;
    result.node = node;
    result.dofs = node_dofs_[node];
    result.x = position(q, node);
    result.area = node_area_[node];
    result.reference_coordinate = mesh_.nodes()[node][0];
    result.arc_coordinate = mesh_.arc_length()[node];
    result.thickness = node_thickness_[node];
    result.compliance = result.area > 0 ? .5 * h / (modulus() * result.area) : 0.;
    result.recovery = thickness == ContactThickness::current ? node_relief_[node] : 0.;
    result.jacobian[0] = Tensor1({1., 0.});
    result.jacobian[1] = Tensor1({0., 1.});
    if (contact_point_ == ContactPoint::normal_offset)
    {
      result.n_dofs = 2;
      result.offset = .5 * h;
      return;
    }
    const double theta = node_angle_[node] + rotation(q, node);
    const double arm = side == Side::top ? .5 * h : -.5 * h;
    const Tensor1 d({-std::sin(theta), std::cos(theta)}), t({std::cos(theta), std::sin(theta)});
    result.n_dofs = 3;
    result.offset = 0.;
    result.x += arm * d;
    result.jacobian[2] = -arm * t;
    result.second[2] = -arm * d;
  }


  static const Registry<Blank>::Entry
    entry("shell", "shell of revolution, or strip in plane strain: bending, finite strain", &make_as<Shell, Blank>);
} // namespace deltaform
