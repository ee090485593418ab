#include "solid_points.h"

#include <deltaform/process/ranks.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <Eigen/Dense>

#include <cmath>

namespace deltaform
{
  /// A share of the volume, sent byte by byte.
  struct VolumeShare
  {
    DofIndex dof;
    double volume;
  };


  void SolidPoints::set_up()
  {
    const dealii::FE_Q<2> shapes(space_.degree());
    const dealii::QGauss<2> quadrature(space_.degree() + 1);
    unit_points_ = quadrature.get_points();
    std::vector<UnitPoint> unit(per_cell()); // the same on every cell
    for (unsigned int p = 0; p < per_cell(); ++p)
    {
      unit[p].weight = quadrature.weight(p);
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      {
        unit[p].shape[a] = shapes.shape_value(a, quadrature.point(p));
        unit[p].gradient[a] = shapes.shape_grad(a, quadrature.point(p));
      }
    }

    points_.clear();
    points_.reserve(space_.cells().size() * per_cell());
    projection_.clear();
    projection_.reserve(points_.capacity() * per_cell());
    for (const auto &cell : space_.cells())
    {
      for (const auto &point : unit)
        points_.push_back(make_point(cell, point));
      add_projection();
    }
  }


  SolidPoint SolidPoints::make_point(const SolidSpace::Cell &cell, const UnitPoint &unit) const
  {
    SolidPoint point;
    Tensor2 jacobian; // dX/dxi
    double radius = 0;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
    {
      const Point2 &X = space_.nodes()[cell[a]];
      point.shape[a] = unit.shape[a];
      radius += point.shape[a] * X[0];
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          jacobian[i][j] += X[i] * unit.gradient[a][j];
    }
    point.across = Tensor1({jacobian[0][1], jacobian[1][1]}); // cells of a strip stand upright in their columns
    const double determinant = dealii::determinant(jacobian);
    point.radius = space_.axisymmetric() ? radius : 1.;
    point.weight = (space_.axisymmetric() ? 2 * dealii::numbers::PI * radius : 1.) * determinant * unit.weight;
    if (point.weight > 0)
    {
      const Tensor2 inverse = dealii::invert(jacobian);
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      {
        const Tensor1 gradient = unit.gradient[a] * inverse;
        point.gradient_r[a] = gradient[0];
        point.gradient_z[a] = gradient[1];
      }
    }
    return point;
  }


  void SolidPoints::add_projection()
  {
    const unsigned int n = per_cell(), n_modes = space_.degree() == 1 ? 1 : 3;
    Eigen::MatrixXd modes(n, n_modes), weights = Eigen::MatrixXd::Zero(n, n);
    for (unsigned int p = 0; p < n; ++p)
    {
      modes(p, 0) = 1.;
      for (unsigned int k = 1; k < n_modes; ++k)
        modes(p, k) = unit_points_[p][k - 1] - .5;
      weights(p, p) = points_[points_.size() - n + p].weight;
    }
    const Eigen::MatrixXd projection =
      modes * (modes.transpose() * weights * modes).ldlt().solve(modes.transpose() * weights);
    for (unsigned int p = 0; p < n; ++p)
      for (unsigned int k = 0; k < n; ++k)
        projection_.push_back(projection(p, k));
  }


  Deformation SolidPoints::deformation(const Vector &u, const unsigned int cell, const unsigned int point) const
  {
    const SolidPoint &place = points_[cell * per_cell() + point];
    Deformation F;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
    {
      const auto &dofs = space_.dofs()[space_.cells()[cell][a]];
      F.f[0] += place.gradient_r[a] * u[dofs[0]];
      F.f[1] += place.gradient_z[a] * u[dofs[0]];
      F.f[2] += place.gradient_r[a] * u[dofs[1]];
      F.f[3] += place.gradient_z[a] * u[dofs[1]];
      if (space_.axisymmetric())
        F.hoop += place.shape[a] * u[dofs[0]] / place.radius;
    }
    return F;
  }


  Point2 SolidPoints::place(const unsigned int point) const
  {
    const auto &cell = space_.cells()[point / per_cell()];
    Point2 result;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      result += points_[point].shape[a] * space_.nodes()[cell[a]];
    return result;
  }


  std::vector<double> SolidPoints::to_nodes(const std::vector<double> &point_values) const
  {
    std::vector<double> result(space_.nodes().size(), 0.), volume(result);
    for (unsigned int p = 0; p < points_.size(); ++p)
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      {
        const double share = std::abs(points_[p].shape[a]) * points_[p].weight;
        const unsigned int node = space_.cells()[p / per_cell()][a];
        result[node] += share * point_values[p];
        volume[node] += share;
      }
    ranks::sum(result.data(), result.size());
    ranks::sum(volume.data(), volume.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] /= volume[i];
    return result;
  }


  std::vector<std::pair<DofIndex, double>> SolidPoints::volume_weights(const unsigned int k) const
  {
    std::vector<VolumeShare> own;
    for (unsigned int p = 0; p < points_.size(); ++p)
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      {
        const double weight = points_[p].shape[a] * points_[p].weight;
        space_.hanging().each_unknown(space_.dofs()[space_.cells()[p / per_cell()][a]][k],
                                      [&](const DofIndex dof, const double share) {
                                        own.push_back({dof, share * weight});
                                      });
      }
    std::vector<std::pair<DofIndex, double>> result;
    for (const auto &[dof, volume] : ranks::gather(own))
      result.emplace_back(dof, volume);
    return result;
  }
} // namespace deltaform
