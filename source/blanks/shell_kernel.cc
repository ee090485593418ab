#include "shell_kernel.h"
#include "shell_work.h"

#include <cmath>

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
  Status ShellKernel::assemble_cells(const Vector &q, AssemblyTarget &target)
  {
    constexpr unsigned int n_dofs = 3 * n_nodes;
    const ShellMesh &mesh = space_.mesh();
    const bool axisymmetric = space_.axisymmetric();
    const unsigned int n_points = points_.per_cell(), n_layers = points_.n_layers(), per_cell = n_points * n_layers;
    const bool tangent = target.wants_tangent();
    const double stiffness = shear_stiffness();

    std::vector<double> layer_tangent(tangent ? per_cell * 16 : 0);
    std::vector<std::array<double, 4>> layer_geometry(per_cell); // 1/a1, 1/a2, zeta, weight
    std::vector<ShellStrain> strains;
    std::array<DofIndex, n_dofs> dofs;
    std::array<double, n_dofs> residual;
    std::array<double, n_dofs * n_dofs> matrix;
    Status status;

    for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    {
      const auto &cell = mesh.cells()[c];
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 3; ++k)
          dofs[3 * a + k] = space_.dofs()[cell.nodes[a]][k];

      // Logarithmic strains of all layers of all quadrature points of the cell
      strains.clear();
      const unsigned int first = c * per_cell;
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const ShellPoint &point = points_[c * n_points + p];
        strains.push_back(shell_strain<n_nodes, membrane>(point, cell, mesh.nodes(), q, dofs.data(), axisymmetric));
        const ShellStrain &strain = strains.back();
        const double ratio = state_.thickness_ratio(c * n_points + p);
        for (unsigned int l = 0; l < n_layers; ++l)
        {
          const unsigned int i = p * n_layers + l;
          const double zeta = ratio * points_.layer_position(l);
          const double a1 = strain.lambda - zeta * strain.theta_prime;
          const double a2 = axisymmetric ? strain.r + zeta * strain.d_r() : 1.;
          const double a1_zero = point.lambda - points_.layer_position(l) * point.angle_prime;
          const double a2_zero = axisymmetric ? point.radius - points_.layer_position(l) * std::sin(point.angle) : 1.;
          if (!(a1 > 0) || !(a2 > 0))
            return Status::shorten("a layer of the shell is turned inside out", c);
          Mandel &e = material_.strain(first + i);
          e[0] = std::log(a1 / a1_zero);
          e[1] = axisymmetric ? std::log(a2 / a2_zero) : 0.;
          e[3] = 0.;
          layer_geometry[i] = {{1. / a1, 1. / a2, zeta, point.weight * points_.layer_weight(l) * a1_zero * a2_zero}};
        }
      }

      Status cell_status =
        material_.update(first, per_cell, tangent ? layer_tangent.data() : nullptr, state_.third_stress(first));
      if (!cell_status.good())
      {
        cell_status.place = c;
        status.merge(cell_status);
        return status;
      }

      residual.fill(0.);
      if (tangent)
        matrix.fill(0.);
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const ShellPoint &point = points_[c * n_points + p];
        const ShellStrain &strain = strains[p];
        Resultants total;
        auto &n = total.n;
        auto &g = total.g;
        for (unsigned int l = 0; l < n_layers; ++l)
        {
          const unsigned int i = p * n_layers + l;
          const auto &[i1, i2, zeta, weight] = layer_geometry[i];
          const Mandel &tau = material_.stress(first + i);
          const double s1 = weight * tau[0] * i1;
          const double s2 = axisymmetric ? weight * tau[1] * i2 : 0.;
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
            if (axisymmetric)
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
        const double shear = stiffness * point.weight * point.radius;
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


  Status ShellKernel::assemble(const Vector &q, AssemblyTarget &target)
  {
    if (space_.membrane())
      return space_.degree() == 1 ? assemble_cells<2, true>(q, target) : assemble_cells<3, true>(q, target);
    return space_.degree() == 1 ? assemble_cells<2, false>(q, target) : assemble_cells<3, false>(q, target);
  }


  double ShellKernel::shear_stiffness() const
  {
    return space_.membrane() ? 0. : shear_factor_ * material_.law().shear_modulus() * points_.thickness();
  }
} // namespace deltaform
