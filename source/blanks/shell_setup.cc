// Unknowns, quadrature points and nodes of the shell.
#include "shell.h"

#include <deltaform/kinematics/shell_strain.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace deltaform
{
  using dealii::numbers::PI;

  void Shell::set_up_dofs()
  {
    // One cell of the triangulation per element; for degree 2 only the ends of an element are vertices.
    std::vector<Point2> vertices;
    std::vector<dealii::CellData<1>> cells;
    vertices.push_back(mesh_.nodes()[mesh_.cells().front().nodes[0]]);
    for (const auto &cell : mesh_.cells())
    {
      vertices.push_back(mesh_.nodes()[cell.nodes[1]]);
      dealii::CellData<1> data;
      data.vertices = {static_cast<unsigned int>(vertices.size() - 2), static_cast<unsigned int>(vertices.size() - 1)};
      cells.push_back(data);
    }
    triangulation_.create_triangulation(vertices, cells, dealii::SubCellData());

    element_ = std::make_unique<dealii::FESystem<1, 2>>(dealii::FE_Q<1, 2>(degree_), 3);
    dof_handler_.distribute_dofs(*element_);

    node_dofs_.resize(mesh_.nodes().size());
    is_rotation_.assign(dof_handler_.n_dofs(), false);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    for (const auto &cell : dof_handler_.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const auto [component, node] = element_->system_to_component_index(i);
        node_dofs_[mesh_.cells()[cell->active_cell_index()].nodes[node]][component] = dofs[i];
        is_rotation_[dofs[i]] = component == 2;
      }
    }
    for (const auto &cell : mesh_.cells())
      edges_.push_back(cell.nodes);
  }


  void Shell::set_up_points()
  {
    const unsigned int n_nodes = degree_ + 1;
    const dealii::FE_Q<1> shapes(degree_);
    const dealii::QGauss<1> quadrature(degree_), load_quadrature(degree_ + 1);
    const double factor = axisymmetric_ ? 2 * PI : 1.;
    n_points_per_cell_ = quadrature.size();

    for (const auto &cell : mesh_.cells())
      for (unsigned int p = 0; p < quadrature.size(); ++p)
      {
        ShellPoint point;
        Tensor1 X_xi;
        double radius = 0, angle_xi = 0;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          point.shape[a] = shapes.shape_value(a, quadrature.point(p));
          point.gradient[a] = shapes.shape_grad(a, quadrature.point(p))[0];
          X_xi += point.gradient[a] * mesh_.nodes()[cell.nodes[a]];
          radius += point.shape[a] * mesh_.nodes()[cell.nodes[a]][0];
          point.angle += point.shape[a] * cell.angle[a];
          angle_xi += point.gradient[a] * cell.angle[a];
        }
        const double dS = X_xi.norm();
        for (auto &gradient : point.gradient)
          gradient /= dS;
        point.angle_prime = membrane_ ? 0. : angle_xi / dS;
        point.radius = axisymmetric_ ? radius : 1.;
        point.weight = factor * dS * quadrature.weight(p);
        if (membrane_)
          point.angle = std::atan2(X_xi[1], X_xi[0]);
        const ShellStrain reference(X_xi / dS, point.angle, point.angle_prime, point.radius);
        point.lambda = reference.lambda;
        point.gamma = reference.gamma;
        points_.push_back(point);
      }

    for (unsigned int p = 0; p < load_quadrature.size(); ++p)
    {
      LoadPoint point;
      point.weight = load_quadrature.weight(p);
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        point.shape[a] = shapes.shape_value(a, load_quadrature.point(p));
        point.gradient[a] = shapes.shape_grad(a, load_quadrature.point(p))[0];
      }
      load_quadrature_.push_back(point);
    }

    const unsigned int n = points_.size() * n_layers_;
    material_.reset(n);
    committed_strain_.assign(n, Mandel{});
    third_stress_.assign(n, 0.);
    thickness_ratio_.assign(points_.size(), 1.);
  }


  void Shell::set_up_nodes()
  {
    const unsigned int n = mesh_.nodes().size();
    node_weight_.assign(n, 0.);
    node_angle_.assign(n, 0.);
    std::vector<unsigned int> count(n, 0);
    for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
    {
      const auto &cell = mesh_.cells()[c];
      for (unsigned int a = 0; a <= degree_; ++a)
      {
        // At a kink the contact director is the mean of its neighbours'; angles of one node differ by less than pi.
        node_angle_[cell.nodes[a]] += cell.angle[a];
        ++count[cell.nodes[a]];
        for (unsigned int p = 0; p < n_points_per_cell_; ++p)
        {
          const ShellPoint &point = points_[c * n_points_per_cell_ + p];
          node_weight_[cell.nodes[a]] += std::abs(point.shape[a]) * point.weight * point.radius;
        }
      }
    }
    for (unsigned int i = 0; i < n; ++i)
      node_angle_[i] /= count[i];
    node_thickness_.assign(n, thickness_);
    node_relief_.assign(n, 0.);
    node_area_.assign(n, 0.);
    contact_pressure_[0].assign(n, 0.);
    contact_pressure_[1].assign(n, 0.);
    weightless_.assign(n, false);
    update_areas(Vector(n_dofs()));
    for (unsigned int i = 0; i < n; ++i)
      weightless_[i] = node_area_[i] < 1e-9 * node_weight_[i];
    update_areas(Vector(n_dofs()));
  }
} // namespace deltaform
