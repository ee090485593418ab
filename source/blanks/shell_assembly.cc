// Internal forces and tangent of the shell, and the loads on its area.
#include "shell.h"
#include "shell_point.h"

#include <deltaform/base/assembly_target.h>
#include <deltaform/kinematics/shell_strain.h>

namespace deltaform
{
  namespace
  {
    /// Resultants over the thickness: generalized stresses n and their derivatives g with respect to the generalized
    /// strains.
    struct Resultants
    {
      std::array<double, ShellStrain::size> n{};
      std::array<std::array<double, ShellStrain::size>, ShellStrain::size> g{};
    };
  } // namespace


  template <unsigned int n_nodes, bool membrane>
  Status Shell::assemble_cells(const Vector &q, AssemblyTarget &target)
  {
    constexpr unsigned int n_dofs = 3 * n_nodes;
    const unsigned int n_cells = mesh_.cells().size();
    const unsigned int per_cell = n_points_per_cell_ * n_layers_;
    const bool tangent = target.wants_tangent();
    const double shear_stiffness = membrane ? 0. : shear_factor_ * material_.law().shear_modulus() * thickness_;

    std::vector<double> layer_tangent(tangent ? per_cell * 16 : 0);
    std::vector<std::array<double, 4>> layer_geometry(per_cell); // 1/a1, 1/a2, zeta, weight
    std::vector<ShellStrain> strains;
    std::array<DofIndex, n_dofs> dofs;
    std::array<double, n_dofs> residual;
    std::array<double, n_dofs * n_dofs> matrix;
    Status status;

    for (unsigned int c = 0; c < n_cells; ++c)
    {
      const auto &cell = mesh_.cells()[c];
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 3; ++k)
          dofs[3 * a + k] = node_dofs_[cell.nodes[a]][k];

      // Logarithmic strains of all layers of all quadrature points of the cell
      strains.clear();
      const unsigned int first = c * per_cell;
      for (unsigned int p = 0; p < n_points_per_cell_; ++p)
      {
        const ShellPoint &point = points_[c * n_points_per_cell_ + p];
        strains.push_back(shell_strain<n_nodes, membrane>(point, cell, mesh_.nodes(), q, dofs.data(), axisymmetric_));
        const ShellStrain &strain = strains.back();
        const double ratio = thickness_ratio_[c * n_points_per_cell_ + p];
        for (unsigned int l = 0; l < n_layers_; ++l)
        {
          const unsigned int i = p * n_layers_ + l;
          const double zeta = ratio * layer_position_[l];
          const double a1 = strain.lambda - zeta * strain.theta_prime;
          const double a2 = axisymmetric_ ? strain.r + zeta * strain.d_r() : 1.;
          const double a1_zero = point.lambda - layer_position_[l] * point.angle_prime;
          const double a2_zero = axisymmetric_ ? point.radius - layer_position_[l] * std::sin(point.angle) : 1.;
          if (!(a1 > 0) || !(a2 > 0))
            return Status::shorten("a layer of the shell is turned inside out", c);
          Mandel &e = material_.strain(first + i);
          e[0] = std::log(a1 / a1_zero);
          e[1] = axisymmetric_ ? std::log(a2 / a2_zero) : 0.;
          e[3] = 0.;
          layer_geometry[i] = {{1. / a1, 1. / a2, zeta, point.weight * layer_weight_[l] * a1_zero * a2_zero}};
        }
      }

      Status cell_status =
        material_.update(first, per_cell, tangent ? layer_tangent.data() : nullptr, &third_stress_[first]);
      if (!cell_status.good())
      {
        cell_status.place = c;
        status.merge(cell_status);
        return status;
      }

      residual.fill(0.);
      if (tangent)
        matrix.fill(0.);
      for (unsigned int p = 0; p < n_points_per_cell_; ++p)
      {
        const ShellPoint &point = points_[c * n_points_per_cell_ + p];
        const ShellStrain &strain = strains[p];
        Resultants total;
        auto &n = total.n;
        auto &g = total.g;
        for (unsigned int l = 0; l < n_layers_; ++l)
        {
          const unsigned int i = p * n_layers_ + l;
          const auto &[i1, i2, zeta, weight] = layer_geometry[i];
          const Mandel &tau = material_.stress(first + i);
          const double s1 = weight * tau[0] * i1;
          const double s2 = axisymmetric_ ? weight * tau[1] * i2 : 0.;
          n[ShellStrain::stretch] += s1;
          n[ShellStrain::curvature] -= zeta * s1;
          n[ShellStrain::radius] += s2;
          n[ShellStrain::director_r] += zeta * s2;
          if (tangent)
          {
            const double *t = &layer_tangent[16 * i];
            const double k11 = weight * (t[0] - tau[0]) * i1 * i1;
            g[0][0] += k11;
            g[0][1] -= zeta * k11;
            g[1][1] += zeta * zeta * k11;
            if (axisymmetric_)
            {
              const double k12 = weight * t[1] * i1 * i2;
              const double k22 = weight * (t[5] - tau[1]) * i2 * i2;
              g[0][2] += k12;
              g[0][3] += zeta * k12;
              g[1][2] -= zeta * k12;
              g[1][3] -= zeta * zeta * k12;
              g[2][2] += k22;
              g[2][3] += zeta * k22;
              g[3][3] += zeta * zeta * k22;
            }
          }
        }
        const double shear = shear_stiffness * point.weight * point.radius;
        n[ShellStrain::shear] = shear * (strain.gamma - point.gamma);
        g[4][4] = shear;
        for (unsigned int i = 1; i < 4; ++i)
          for (unsigned int j = 0; j < i; ++j)
            g[i][j] = g[j][i];

        add_point<n_nodes, membrane>(point, strain, n, g, tangent, residual, matrix);
      }
      target.add(dofs.data(), n_dofs, tangent ? matrix.data() : nullptr, residual.data());
    }
    return status;
  }


  Status Shell::assemble(const Vector &q, AssemblyTarget &target)
  {
    if (membrane_)
      return degree_ == 1 ? assemble_cells<2, true>(q, target) : assemble_cells<3, true>(q, target);
    return degree_ == 1 ? assemble_cells<2, false>(q, target) : assemble_cells<3, false>(q, target);
  }


  void Shell::assemble_pressure(const Vector &q,
                                const std::string &,
                                const double pressure,
                                const bool following,
                                AssemblyTarget &target) const
  {
    const unsigned int n_nodes = degree_ + 1, n_dofs = 3 * n_nodes;
    const bool tangent = target.wants_tangent() && following;
    const double factor = axisymmetric_ ? 2 * dealii::numbers::PI : 1.;
    std::array<DofIndex, 9> dofs;
    std::array<double, 9> residual;
    std::array<double, 81> matrix;
    for (const auto &cell : mesh_.cells())
    {
      residual.fill(0.);
      matrix.fill(0.);
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        x[a] = following ? position(q, cell.nodes[a]) : mesh_.nodes()[cell.nodes[a]];
        for (unsigned int k = 0; k < 3; ++k)
          dofs[3 * a + k] = node_dofs_[cell.nodes[a]][k];
      }
      for (const auto &[shape, gradient, weight] : load_quadrature_)
      {
        Tensor1 x_xi;
        double r = 0;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          x_xi += gradient[a] * x[a];
          r += shape[a] * x[a][0];
        }
        if (!axisymmetric_)
          r = 1.;
        const double w = factor * weight * pressure;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          residual[3 * a] -= w * shape[a] * r * (-x_xi[1]);
          residual[3 * a + 1] -= w * shape[a] * r * x_xi[0];
          if (tangent)
            for (unsigned int b = 0; b < n_nodes; ++b)
            {
              double *row_r = &matrix[(3 * a) * n_dofs + 3 * b];
              double *row_z = &matrix[(3 * a + 1) * n_dofs + 3 * b];
              row_r[1] += w * shape[a] * r * gradient[b];
              row_z[0] -= w * shape[a] * r * gradient[b];
              if (axisymmetric_)
              {
                row_r[0] += w * shape[a] * x_xi[1] * shape[b];
                row_z[0] -= w * shape[a] * x_xi[0] * shape[b];
              }
            }
        }
      }
      target.add(dofs.data(), n_dofs, tangent ? matrix.data() : nullptr, residual.data());
    }
  }
} // namespace deltaform
