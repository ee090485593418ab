#pragma once
// The work at one quadrature point on the meridian of a shell: strain from the unknowns, forces from the resultants.
#include "shell_points.h"

#include <deltaform/kinematics/shell_strain.h>

#include <algorithm>
#include <array>

namespace deltaform
{
  /// Generalized strain at a point. A membrane has no rotation of its own: its director is normal to the meridian.
  template <unsigned int n_nodes, bool membrane>
  ShellStrain shell_strain(const ShellPoint &point,
                           const ShellMesh::Cell &cell,
                           const std::vector<Point2> &nodes,
                           const Vector &q,
                           const DofIndex *dofs,
                           const bool axisymmetric)
  {
    Tensor1 x_prime;
    double r = 0, rotation = 0, rotation_prime = 0;
    for (unsigned int a = 0; a < n_nodes; ++a)
    {
      const Point2 &X = nodes[cell.nodes[a]];
      const double x_r = X[0] + q[dofs[3 * a]], x_z = X[1] + q[dofs[3 * a + 1]];
      x_prime[0] += point.gradient[a] * x_r;
      x_prime[1] += point.gradient[a] * x_z;
      r += point.shape[a] * x_r;
      if (!membrane)
      {
        rotation += point.shape[a] * q[dofs[3 * a + 2]];
        rotation_prime += point.gradient[a] * q[dofs[3 * a + 2]];
      }
    }
    if (!axisymmetric)
      r = 1.;
    if (membrane)
      return {x_prime, std::atan2(x_prime[1], x_prime[0]), 0., r};
    return {x_prime, point.angle + rotation, point.angle_prime + rotation_prime, r};
  }


  /// B, the derivatives of the generalized strain by the unknowns.
  template <unsigned int n_nodes>
  using ShellGradient = std::array<std::array<double, 3 * n_nodes>, ShellStrain::size>;


  template <unsigned int n_nodes, bool membrane>
  ShellGradient<n_nodes> shell_gradient(const ShellPoint &point, const ShellStrain &strain)
  {
    ShellGradient<n_nodes> b;
    for (unsigned int a = 0; a < n_nodes; ++a)
    {
      auto node = strain.derivative(point.shape[a], point.gradient[a]);
      if (membrane)
        for (auto &row : node)
          row[2] = 0.;
      for (unsigned int s = 0; s < ShellStrain::size; ++s)
        for (unsigned int k = 0; k < 3; ++k)
          b[s][3 * a + k] = node[s][k];
    }
    return b;
  }


  /// Add B^T g B.
  template <unsigned int n_nodes, typename Stiffness, typename Matrix>
  void add_material_stiffness(const ShellGradient<n_nodes> &b, const Stiffness &g, Matrix &matrix)
  {
    constexpr unsigned int n_dofs = 3 * n_nodes;
    // Of the strains with a stiffness: in plane strain three of five.
    std::array<unsigned int, ShellStrain::size> stiff;
    std::array<std::array<double, n_dofs>, ShellStrain::size> gb{};
    unsigned int n_stiff = 0;
    for (unsigned int s = 0; s < ShellStrain::size; ++s)
    {
      bool is_stiff = false;
      for (unsigned int t = 0; t < ShellStrain::size; ++t)
        if (g[s][t] != 0.)
        {
          is_stiff = true;
          for (unsigned int j = 0; j < n_dofs; ++j)
            gb[n_stiff][j] += g[s][t] * b[t][j];
        }
      if (is_stiff)
        stiff[n_stiff++] = s;
    }
    for (unsigned int i = 0; i < n_dofs; ++i)
    {
      std::array<double, n_dofs> row;
      std::copy_n(matrix.begin() + i * n_dofs, n_dofs, row.begin());
      for (unsigned int k = 0; k < n_stiff; ++k)
        for (unsigned int j = 0; j < n_dofs; ++j)
          row[j] += b[stiff[k]][i] * gb[k][j];
      std::copy_n(row.begin(), n_dofs, matrix.begin() + i * n_dofs);
    }
  }


  /// Add the second derivatives of the generalized strain times the resultants @p n.
  template <unsigned int n_nodes, bool membrane, typename Stress, typename Matrix>
  void add_geometric_stiffness(const ShellPoint &point, const ShellStrain &strain, const Stress &n, Matrix &matrix)
  {
    constexpr unsigned int n_dofs = 3 * n_nodes;
    if (membrane)
    {
      // Lambda = |x'|: its second derivative is d (x) d / |x'|
      const Tensor1 d({-strain.sine, strain.cosine});
      const double factor = n[ShellStrain::stretch] / strain.lambda;
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int c = 0; c < n_nodes; ++c)
          for (unsigned int k = 0; k < 2; ++k)
            for (unsigned int l = 0; l < 2; ++l)
              matrix[(3 * a + k) * n_dofs + 3 * c + l] += factor * point.gradient[a] * point.gradient[c] * d[k] * d[l];
      return;
    }
    const auto geometric = strain.geometric(n);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int c = 0; c < n_nodes; ++c)
      {
        for (unsigned int k = 0; k < 2; ++k)
        {
          const double mixed = point.gradient[a] * point.shape[c] * geometric.mixed[k];
          matrix[(3 * a + k) * n_dofs + 3 * c + 2] += mixed;
          matrix[(3 * c + 2) * n_dofs + 3 * a + k] += mixed;
        }
        matrix[(3 * a + 2) * n_dofs + 3 * c + 2] += point.shape[a] * point.shape[c] * geometric.rotation;
      }
  }


  /// Add B^T n to the residual and, for a tangent, B^T g B + geometric stiffness to the matrix.
  template <unsigned int n_nodes,
            bool membrane,
            typename Stress,
            typename Stiffness,
            typename Residual,
            typename Matrix>
  void add_point(const ShellPoint &point,
                 const ShellStrain &strain,
                 const Stress &n,
                 const Stiffness &g,
                 const bool tangent,
                 Residual &residual,
                 Matrix &matrix)
  {
    const auto b = shell_gradient<n_nodes, membrane>(point, strain);
    for (unsigned int s = 0; s < ShellStrain::size; ++s)
      for (unsigned int i = 0; i < 3 * n_nodes; ++i)
        residual[i] += n[s] * b[s][i];
    if (!tangent)
      return;
    add_material_stiffness<n_nodes>(b, g, matrix);
    add_geometric_stiffness<n_nodes, membrane>(point, strain, n, matrix);
  }
} // namespace deltaform
