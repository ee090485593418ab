#include "shell_points.h"
#include "shell_work.h"

#include <deltaform/parameters/section.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace deltaform
{
  ShellPoints::ShellPoints(Section &section, const ShellSettings &settings, const ShellSpace &space)
    : space_(space), n_points_per_cell_(space.degree()), thickness_(settings.thickness)
  {
    const std::string rule =
      section.choice("Layer rule",
                     "gauss",
                     {"gauss", "lobatto", "elastic core"},
                     "Integration through the thickness. elastic core: Gauss, and the kinks of the stress where the "
                     "elastic core ends by themselves; for bending and springback, not for drawing.");
    with_elastic_core_ = rule == "elastic core" && !settings.membrane;
    const unsigned int n_layers = settings.n_layers;
    const dealii::Quadrature<1> layers = rule != "lobatto" || n_layers < 2
                                           ? dealii::Quadrature<1>(dealii::QGauss<1>(n_layers))
                                           : dealii::Quadrature<1>(dealii::QGaussLobatto<1>(n_layers));
    for (unsigned int l = 0; l < n_layers; ++l)
    {
      layer_position_.push_back(thickness_ * (layers.point(l)[0] - .5));
      layer_weight_.push_back(thickness_ * layers.weight(l));
    }

    set_up();
  }


  void ShellPoints::set_up()
  {
    const dealii::FE_Q<1> shapes(space_.degree());
    const dealii::QGauss<1> quadrature(n_points_per_cell_);
    points_.clear();
    node_weight_.assign(space_.n_nodes(), 0.);
    for (const auto &cell : space_.mesh().cells())
      for (unsigned int p = 0; p < quadrature.size(); ++p)
      {
        std::array<double, 3> shape{}, gradient{};
        for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
        {
          shape[a] = shapes.shape_value(a, quadrature.point(p));
          gradient[a] = shapes.shape_grad(a, quadrature.point(p))[0];
        }
        points_.push_back(make_point(cell, shape, gradient, quadrature.weight(p)));
      }
    for (unsigned int c = 0; c < space_.mesh().cells().size(); ++c)
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
        for (unsigned int p = c * n_points_per_cell_; p < (c + 1) * n_points_per_cell_; ++p)
          node_weight_[space_.mesh().cells()[c].nodes[a]] +=
            std::abs(points_[p].shape[a]) * points_[p].weight * points_[p].radius;
  }


  ShellPoint ShellPoints::make_point(const ShellMesh::Cell &cell,
                                     const std::array<double, 3> &shape,
                                     const std::array<double, 3> &gradient,
                                     const double weight) const
  {
    ShellPoint point;
    point.shape = shape;
    point.gradient = gradient;
    Tensor1 X_xi;
    double radius = 0, angle_xi = 0;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
    {
      const Point2 &X = space_.mesh().nodes()[cell.nodes[a]];
      X_xi += gradient[a] * X;
      radius += shape[a] * X[0];
      point.angle += shape[a] * cell.angle[a];
      angle_xi += gradient[a] * cell.angle[a];
    }
    const double dS = X_xi.norm();
    for (auto &derivative : point.gradient)
      derivative /= dS;
    point.angle_prime = space_.membrane() ? 0. : angle_xi / dS;
    point.radius = space_.axisymmetric() ? radius : 1.;
    point.weight = (space_.axisymmetric() ? 2 * dealii::numbers::PI : 1.) * dS * weight;
    if (space_.membrane())
      point.angle = std::atan2(X_xi[1], X_xi[0]);
    const ShellStrain reference(X_xi / dS, point.angle, point.angle_prime, point.radius);
    point.lambda = reference.lambda;
    point.gamma = reference.gamma;
    return point;
  }


  std::vector<double> ShellPoints::layer_shares() const
  {
    std::vector<double> shares = layer_weight_;
    for (double &share : shares)
      share /= thickness_;
    return shares;
  }


  Point2 ShellPoints::place(const unsigned int point) const
  {
    const auto &nodes = space_.mesh().cells()[point / n_points_per_cell_].nodes;
    Point2 result;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      result += points_[point].shape[a] * space_.mesh().nodes()[nodes[a]];
    return result;
  }


  ShellStrain ShellPoints::strain(const Vector &q, const unsigned int cell, const unsigned int point) const
  {
    const auto &nodes = space_.mesh().cells()[cell].nodes;
    std::array<DofIndex, 9> dofs{};
    for (unsigned int a = 0; a <= space_.degree(); ++a)
      std::copy(space_.dofs()[nodes[a]].begin(), space_.dofs()[nodes[a]].end(), dofs.begin() + 3ul * a);
    const auto evaluate = [&](auto n_nodes, auto membrane) {
      return shell_strain<n_nodes, membrane>(
        points_[point], space_.mesh().cells()[cell], space_.mesh().nodes(), q, dofs.data(), space_.axisymmetric());
    };
    using Two = std::integral_constant<unsigned int, 2>;
    using Three = std::integral_constant<unsigned int, 3>;
    if (space_.membrane())
      return space_.degree() == 1 ? evaluate(Two(), std::true_type()) : evaluate(Three(), std::true_type());
    return space_.degree() == 1 ? evaluate(Two(), std::false_type()) : evaluate(Three(), std::false_type());
  }


  std::vector<double> ShellPoints::to_nodes(const std::vector<double> &point_values) const
  {
    const auto &cells = space_.mesh().cells();
    std::vector<double> result(space_.n_nodes(), 0.);
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int p = c * n_points_per_cell_; p < (c + 1) * n_points_per_cell_; ++p)
      {
        const ShellPoint &point = points_[p];
        for (unsigned int a = 0; a <= space_.degree(); ++a)
          result[cells[c].nodes[a]] +=
            std::abs(point.shape[a]) * point.weight * point.radius * point_values[p];
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] /= node_weight_[i];
    return result;
  }


  void ShellPoints::to_edges(const std::vector<double> &point_values, std::vector<double> &node_values) const
  {
    const ShellMesh &mesh = space_.mesh();
    const unsigned int n = size();
    if (mesh.cells().size() < 2)
      return;
    const auto arc = [&](const unsigned int p) {
      const auto &nodes = mesh.cells()[p / n_points_per_cell_].nodes;
      double result = 0.;
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        result += points_[p].shape[a] * mesh.arc_length()[nodes[a]];
      return result;
    };
    const auto continue_to = [&](const unsigned int node, const unsigned int last, const unsigned int before) {
      if (std::abs(mesh.nodes()[node][0]) < 1e-9 * thickness_)
        return;
      const double slope = (point_values[last] - point_values[before]) / (arc(last) - arc(before));
      node_values[node] = point_values[last] + slope * (mesh.arc_length()[node] - arc(last));
    };
    continue_to(mesh.cells().front().nodes[0], 0, 1);
    continue_to(mesh.cells().back().nodes[1], n - 1, n - 2);
  }
} // namespace deltaform
