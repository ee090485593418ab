#pragma once
// Tangent of a cell of the solid: derivation in doc/theory/solid.md, "The tangent of a cell".
#include <deltaform/assembly/types.h>
#include <deltaform/kinematics/logarithmic_strain.h>

#include <Eigen/Dense>

#include <array>

namespace deltaform
{
  /**
   * Derivative of a cell's internal forces, gathered point by point. The force at node a is the sum over the points of
   *
   *     r:  t_rr g_r(a) + t_rz g_z(a) + t_tt g_t(a),     z:  t_zr g_r(a) + t_zz g_z(a),
   *
   * with the weighted stresses t and the spatial gradients g. Every column of the tangent is that sum with the
   * derivatives of t, from which the motion of the gradients, d g_j(a) = -g_l(a) du_l,j, is taken off: five numbers per
   * point and column, whatever the number of nodes. Columns of u_r and of u_z are kept apart, padded to an even number.
   */
  template <unsigned int n_nodes, unsigned int n_points>
  class SolidTangent
  {
  public:
    static constexpr int padded = n_nodes + n_nodes % 2;
    using Columns = Eigen::Array<double, padded, 1>;

    /// Spatial gradients and N/r of all nodes at a point; the padding is zero.
    struct Gradients
    {
      Columns r = Columns::Zero(), z = Columns::Zero(), t = Columns::Zero();
    };

    /// Weighted stress that does the work at a point; zero where the gradients do not move (small strain).
    struct Stress
    {
      double rr = 0, zz = 0, tt = 0, rz = 0;
    };

    using AllGradients = std::array<Gradients, n_points>;

    explicit SolidTangent(const AllGradients &gradients)
      : g_(gradients)
    {
    }

    /// Derivatives of the projected volumetric strain at all points; @p project is row-major from points to points.
    void project_volume(const double *project)
    {
      for (unsigned int p = 0; p < n_points; ++p)
      {
        Columns r = -(g_[p].r + g_[p].t), z = -g_[p].z;
        for (unsigned int k = 0; k < n_points; ++k)
        {
          r += project[p * n_points + k] * (g_[k].r + g_[k].t);
          z += project[p * n_points + k] * g_[k].z;
        }
        volume_[p] = {{r / 3., z / 3.}};
      }
    }

    /// Derivatives of the law's stress at a point: moduli D (4 x 4, row-major) times the rate of the trial strain.
    void set_stress_rate(const unsigned int p, const double *D, const LogarithmicStrain::Rate &rate)
    {
      const Gradients &g = g_[p];
      trace_[p] = {{Columns::Zero(), Columns::Zero()}};
      for (unsigned int s = 0; s < 4; ++s)
      {
        std::array<double, 5> m{};
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int k = 0; k < 5; ++k)
            m[k] += D[4 * s + i] * rate[i][k];
        const double bulk = D[4 * s] + D[4 * s + 1] + D[4 * s + 2];
        rate_[p][s][0] = m[0] * g.r + m[1] * g.z + m[4] * g.t + bulk * volume_[p][0];
        rate_[p][s][1] = m[2] * g.r + m[3] * g.z + bulk * volume_[p][1];
        if (s < 3)
          for (unsigned int k = 0; k < 2; ++k)
            trace_[p][k] += rate_[p][s][k];
      }
    }

    /// What comes to the derivatives where the law has axes that turn with the metal: @p by_angle is d stress / d
    /// angle, the angle is that of the polar decomposition of the in-plane deformation @p f, tan = (f_zr - f_rz)/(f_rr
    /// + f_zz).
    void add_turning(const unsigned int p, const std::array<double, 4> &by_angle, const std::array<double, 4> &f)
    {
      const double c = f[0] + f[3], s = f[2] - f[1], inverse = 1. / (c * c + s * s);
      const double rr = -c * f[1] - s * f[0], rz = -c * f[3] - s * f[2]; // d angle / d (du_r/dr), d (du_r/dz)
      const double zr = c * f[0] - s * f[1], zz = c * f[2] - s * f[3]; // and of u_z
      const Pair angle = {{inverse * (rr * g_[p].r + rz * g_[p].z), inverse * (zr * g_[p].r + zz * g_[p].z)}};
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int k = 0; k < 2; ++k)
        {
          rate_[p][i][k] += by_angle[i] * angle[k];
          if (i < 3)
            trace_[p][k] += by_angle[i] * angle[k];
        }
    }

    /// The matrix (2 n_nodes squared, row-major, u_r and u_z of a node side by side).
    void assemble(const double *project,
                  const std::array<double, n_points> &weight,
                  const std::array<Stress, n_points> &stress,
                  double *matrix) const
    {
      constexpr double root_half = .70710678118654752440;
      constexpr int n = 2 * n_nodes;
      // Derivatives of t_rr, t_rz, t_tt, t_zr, t_zz
      std::array<std::array<std::array<Columns, 5>, 2>, n_points> t;
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const Stress &tau = stress[p];
        for (unsigned int k = 0; k < 2; ++k)
        {
          // The mean stress that works is the projected one.
          Columns mean = -trace_[p][k];
          for (unsigned int m = 0; m < n_points; ++m)
            mean += project[p * n_points + m] * trace_[m][k];
          mean /= 3.;
          t[p][k][0] = weight[p] * (rate_[p][0][k] + mean);
          t[p][k][1] = weight[p] * root_half * rate_[p][3][k];
          t[p][k][2] = weight[p] * (rate_[p][2][k] + mean);
          t[p][k][3] = t[p][k][1];
          t[p][k][4] = weight[p] * (rate_[p][1][k] + mean);
        }
        const Columns along_r = tau.rr * g_[p].r + tau.rz * g_[p].z, along_z = tau.rz * g_[p].r + tau.zz * g_[p].z;
        t[p][0][0] -= along_r;
        t[p][1][1] -= along_r;
        t[p][0][2] -= tau.tt * g_[p].t;
        t[p][0][3] -= along_z;
        t[p][1][4] -= along_z;
      }
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 2; ++k)
        {
          Columns row_r = Columns::Zero(), row_z = Columns::Zero();
          for (unsigned int p = 0; p < n_points; ++p)
          {
            const double r = g_[p].r[a], z = g_[p].z[a];
            row_r += r * t[p][k][0] + z * t[p][k][1] + g_[p].t[a] * t[p][k][2];
            row_z += r * t[p][k][3] + z * t[p][k][4];
          }
          for (unsigned int c = 0; c < n_nodes; ++c)
          {
            matrix[2 * a * n + 2 * c + k] = row_r[c];
            matrix[(2 * a + 1) * n + 2 * c + k] = row_z[c];
          }
        }
    }

  private:
    using Pair = std::array<Columns, 2>; ///< with respect to u_r and u_z

    const AllGradients &g_;
    std::array<Pair, n_points> volume_;
    std::array<std::array<Pair, 4>, n_points> rate_;
    std::array<Pair, n_points> trace_;
  };
} // namespace deltaform
