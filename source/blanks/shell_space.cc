#include "shell_space.h"

#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// An element with its unknowns, points and layers takes at least this; 100 000 of degree 1 took 2.8 kB each with 7
    /// layers, 18.4 kB with 61.
    double element_bytes(const ShellSettings &settings)
    {
      return settings.degree * (700. + 280. * settings.n_layers);
    }
  } // namespace


  ShellSpace::ShellSpace(Section &section, const ShellSettings &settings)
    : degree_(settings.degree), axisymmetric_(settings.axisymmetric), membrane_(settings.membrane),
      thickness_(settings.thickness), mesh_(section, degree_, element_bytes(settings)),
      triangulation_(dealii::Triangulation<1, 2>::none),
      dof_handler_(triangulation_)
  {
    for (const auto &X : mesh_.nodes())
      if (axisymmetric_ && X[0] < 0)
        section.fail("Points", "an axisymmetric meridian must lie at r >= 0");
    number();
    set_up_load_quadrature();
  }


  void ShellSpace::set_mesh(ShellMesh mesh)
  {
    dof_handler_.clear();
    triangulation_.clear();
    mesh_ = std::move(mesh);
    number();
  }


  void ShellSpace::number()
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
    dof_handler_.reinit(triangulation_);
    dof_handler_.distribute_dofs(*element_);

    dofs_.resize(mesh_.nodes().size());
    is_rotation_.assign(dof_handler_.n_dofs(), false);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    for (const auto &cell : dof_handler_.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const auto [component, node] = element_->system_to_component_index(i);
        dofs_[mesh_.cells()[cell->active_cell_index()].nodes[node]][component] = dofs[i];
        is_rotation_[dofs[i]] = component == 2;
      }
    }
    link();
  }


  void ShellSpace::link()
  {
    const auto &cells = mesh_.cells();
    chain_.ahead.resize(n_dofs());
    chain_.behind.resize(n_dofs());
    chain_.rotations = {dofs_[cells.front().nodes[0]][2]};
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      // A node between two elements is the first of one and the second of the other.
      const auto &own = cells[k].nodes, &next = cells[std::min(k + 1, cells.size() - 1)].nodes,
                 &last = cells[k > 0 ? k - 1 : 0].nodes;
      for (unsigned int a = 0; a < n_nodes_per_cell(); ++a)
        for (unsigned int c = 0; c < 3; ++c)
        {
          chain_.ahead[dofs_[own[a]][c]] = dofs_[a == 0 ? own[1] : next[a]][c];
          chain_.behind[dofs_[own[a]][c]] = dofs_[a == 1 ? own[0] : last[a]][c];
        }
      chain_.rotations.push_back(dofs_[own[1]][2]);
    }
  }


  void ShellSpace::set_up_load_quadrature()
  {
    const dealii::FE_Q<1> shapes(degree_);
    const dealii::QGauss<1> quadrature(degree_ + 1);
    for (unsigned int p = 0; p < quadrature.size(); ++p)
    {
      LoadPoint point;
      point.weight = quadrature.weight(p);
      for (unsigned int a = 0; a < n_nodes_per_cell(); ++a)
      {
        point.shape[a] = shapes.shape_value(a, quadrature.point(p));
        point.gradient[a] = shapes.shape_grad(a, quadrature.point(p))[0];
      }
      load_quadrature_.push_back(point);
    }
  }


  std::vector<Point2> ShellSpace::positions(const Vector &q) const
  {
    std::vector<Point2> result;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      result.push_back(position(q, i));
    return result;
  }


  double ShellSpace::chord_angle(const Vector &q, const unsigned int node) const
  {
    const unsigned int before = node > 0 ? node - 1 : node, after = std::min(node + 1, n_nodes() - 1);
    const Tensor1 chord = position(q, after) - position(q, before);
    return std::atan2(chord[1], chord[0]);
  }


  double ShellSpace::bend(const Vector &q, const unsigned int cell) const
  {
    const auto &nodes = mesh_.cells()[cell].nodes;
    const double start = rotation(q, nodes[0]), end = rotation(q, nodes[1]);
    if (degree_ == 1)
      return end - start;
    const double middle = rotation(q, nodes[2]);
    return std::abs(middle - start) > std::abs(end - middle) ? middle - start : end - middle;
  }


  std::vector<double> ShellSpace::areas(const Vector &q) const
  {
    const double factor = axisymmetric_ ? 2 * dealii::numbers::PI : 1.;
    std::vector<double> result(n_nodes(), 0.);
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
          result[cell.nodes[a]] += shape[a] * dA;
      }
    }
    return result;
  }


  void ShellSpace::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &cell : mesh_.cells())
      for (unsigned int a = 0; a <= degree_; ++a)
        for (unsigned int b = 0; b <= degree_; ++b)
          for (const auto i : dofs_[cell.nodes[a]])
            for (const auto j : dofs_[cell.nodes[b]])
              pattern.add(i, j);
  }


  std::vector<DofIndex> ShellSpace::fixed_dofs() const
  {
    std::vector<DofIndex> result;
    for (unsigned int i = 0; i < n_nodes(); ++i)
    {
      const bool on_axis = axisymmetric_ && mesh_.nodes()[i][0] < 1e-12 * thickness_;
      if (on_axis)
        result.push_back(dofs_[i][0]);
      if (on_axis || membrane_)
        result.push_back(dofs_[i][2]);
    }
    return result;
  }


  std::string ShellSpace::describe(const DofIndex dof) const
  {
    const std::array<std::string, 3> names{{"u_r", "u_z", "rotation"}};
    for (unsigned int i = 0; i < n_nodes(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        if (dofs_[i][k] == dof)
          return "node " + std::to_string(i) + " (R0 = " + text::format(mesh_.nodes()[i][0]) +
                 ", Z0 = " + text::format(mesh_.nodes()[i][1]) + "), " + names[k];
    return "unknown " + std::to_string(dof);
  }


  void ShellSpace::rigid_motion(const Vector &q,
                                const Tensor1 &translation,
                                const double rotation,
                                const std::function<void(DofIndex, double)> &set) const
  {
    for (unsigned int i = 0; i < n_nodes(); ++i)
    {
      const Point2 x = position(q, i);
      set(dofs_[i][0], translation[0] - rotation * x[1]);
      set(dofs_[i][1], translation[1] + rotation * x[0]);
      set(dofs_[i][2], rotation);
    }
  }


  double ShellSpace::admissible_step(const Vector &q, const Vector &dq) const
  {
    constexpr double largest_stretch = .3, largest_rotation = .3;
    double factor = 1.;
    for (const auto &cell : mesh_.cells())
    {
      const auto a = cell.nodes[0], b = cell.nodes[1];
      const double length = (position(q, b) - position(q, a)).norm();
      const Tensor1 du({dq[dofs_[b][0]] - dq[dofs_[a][0]], dq[dofs_[b][1]] - dq[dofs_[a][1]]});
      factor = std::min(factor, largest_stretch * length / std::max(du.norm(), 1e-300));
      if (axisymmetric_)
        factor = std::min(factor,
                          largest_stretch * std::max(position(q, b)[0], length) /
                            std::max(std::abs(dq[dofs_[b][0]]), 1e-300));
    }
    for (const auto &dofs : dofs_)
      factor = std::min(factor, largest_rotation / std::max(std::abs(dq[dofs[2]]), 1e-300));
    return factor;
  }
} // namespace deltaform
