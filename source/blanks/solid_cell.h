#pragma once
// The work at one cell of the solid, step by step: derivation in doc/theory/solid.md.
#include "material_points.h"
#include "solid_discretization.h"
#include "solid_motion.h"
#include "solid_tangent.h"

#include <deltaform/kinematics/logarithmic_strain.h>

#include <array>
#include <cmath>

namespace deltaform
{
  /// Axis 2 of the metal at a point is normal to the meridian that the body was built on; both turn with the metal by
  /// the rotation of the polar decomposition of @p F.
  MetalAxes axes_of(const SolidDiscretization &body, bool finite, std::size_t point, const Deformation &F);


  /// A cell: strains of its points from the unknowns, forces and tangent from the stresses that the law has found.
  template <unsigned int n_nodes, unsigned int n_points>
  class SolidCell
  {
  public:
    static constexpr unsigned int n_dofs = 2 * n_nodes;

    SolidCell(const SolidDiscretization &body, MaterialPoints &material, SolidMotion &motion)
      : body_(body), space_(body.space()), points_(body.points()), material_(material), motion_(motion),
        axisymmetric_(body.space().axisymmetric()), finite_(motion.finite()), derivative_(g_)
    {
      // The strain of small kinematics is the symmetric part of the gradient.
      small_[0][0] = small_[1][3] = small_[2][4] = 1.;
      small_[3][1] = small_[3][2] = root_half;
    }

    /// Go to a cell with its unknowns.
    void enter(const unsigned int cell, const Vector &values)
    {
      first_ = cell * n_points;
      project_ = points_.projection(cell);
      const auto &nodes = space_.cells()[cell];
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 2; ++k)
        {
          dofs_[2 * a + k] = space_.dofs()[nodes[a]][k];
          u_[2 * a + k] = values[dofs_[2 * a + k]];
        }
    }

    /// Trial elastic strain of all points, with the volumetric strain of each point. @return false if a point is turned
    /// inside out
    bool set_strains()
    {
      for (unsigned int p = 0; p < n_points; ++p)
      {
        set_deformation(p);
        if (!finite_)
          set_small_strain(p);
        else if (!set_logarithmic_strain(p))
          return false;
      }
      return true;
    }

    /// The volumetric strain of every point becomes the projected one.
    void project_strains()
    {
      for (unsigned int p = 0; p < n_points; ++p)
      {
        double projected = 0;
        for (unsigned int k = 0; k < n_points; ++k)
          projected += project_[p * n_points + k] * volumetric_[k];
        for (unsigned int k = 0; k < 3; ++k)
          material_.strain(first_ + p)[k] += (projected - volumetric_[p] - motion_.volume_offset(first_ + p)) / 3.;
      }
    }

    /// By the law. @param tangent with its moduli
    Status update_stresses(const bool tangent)
    {
      return material_.update(first_, n_points, tangent ? moduli_.data() : nullptr);
    }

    /// Forces of the stress that does work: deviator of each point, projected mean stress.
    void set_forces()
    {
      std::array<double, n_points> mean;
      for (unsigned int p = 0; p < n_points; ++p)
        mean[p] = (material_.stress(first_ + p)[0] + material_.stress(first_ + p)[1] +
                   material_.stress(first_ + p)[2]) /
                  3.;
      residual_.fill(0.);
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const Mandel &tau = material_.stress(first_ + p);
        const double w = points_[first_ + p].weight;
        double shift = -mean[p];
        for (unsigned int k = 0; k < n_points; ++k)
          shift += project_[p * n_points + k] * mean[k];
        const double t_rr = w * (tau[0] + shift), t_zz = w * (tau[1] + shift), t_tt = w * (tau[2] + shift);
        const double t_rz = w * root_half * tau[3];
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          residual_[2 * a] += t_rr * g_[p].r[a] + t_rz * g_[p].z[a] + t_tt * g_[p].t[a];
          residual_[2 * a + 1] += t_rz * g_[p].r[a] + t_zz * g_[p].z[a];
        }
        weight_[p] = w;
        if (finite_)
          stress_[p] = {t_rr, t_zz, t_tt, t_rz};
      }
    }

    /// After the forces.
    void set_tangent()
    {
      derivative_.project_volume(project_);
      for (unsigned int p = 0; p < n_points; ++p)
      {
        derivative_.set_stress_rate(p, &moduli_[16 * p], finite_ ? LogarithmicStrain::rate(b_[p]) : small_);
        if (finite_ && material_.has_axes())
          derivative_.add_turning(p, material_.stress_by_angle(first_ + p), motion_.now(first_ + p).f);
      }
      derivative_.assemble(project_, weight_, stress_, matrix_.data());
    }

    const std::array<DofIndex, n_dofs> &dofs() const
    {
      return dofs_;
    }

    const std::array<double, n_dofs> &residual() const
    {
      return residual_;
    }

    const std::array<double, n_dofs * n_dofs> &matrix() const
    {
      return matrix_;
    }

  private:
    static constexpr double root_half = .70710678118654752440;
    using Tangent = SolidTangent<n_nodes, n_points>;

    void set_deformation(const unsigned int p)
    {
      const SolidPoint &point = points_[first_ + p];
      double h_rr = 0, h_rz = 0, h_zr = 0, h_zz = 0, h_tt = 0;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        h_rr += point.gradient_r[a] * u_[2 * a];
        h_rz += point.gradient_z[a] * u_[2 * a];
        h_zr += point.gradient_r[a] * u_[2 * a + 1];
        h_zz += point.gradient_z[a] * u_[2 * a + 1];
        h_tt += point.shape[a] * u_[2 * a];
      }
      h_tt = axisymmetric_ ? h_tt / point.radius : 0.;
      h_ = {{h_rr, h_rz, h_zr, h_zz, h_tt}};
      Deformation &F = motion_.now(first_ + p);
      F.f = {{1. + h_rr, h_rz, h_zr, 1. + h_zz}};
      F.hoop = 1. + h_tt;
      if (material_.has_axes())
        material_.set_axes(first_ + p, axes_of(body_, finite_, first_ + p, F));
    }

    void set_small_strain(const unsigned int p)
    {
      const SolidPoint &point = points_[first_ + p];
      const double round_part = axisymmetric_ ? 1. / point.radius : 0.;
      const auto [h_rr, h_rz, h_zr, h_zz, h_tt] = h_;
      material_.strain(first_ + p) = {{h_rr, h_zz, h_tt, root_half * (h_rz + h_zr)}};
      volumetric_[p] = h_rr + h_zz + h_tt;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        g_[p].r[a] = point.gradient_r[a];
        g_[p].z[a] = point.gradient_z[a];
        g_[p].t[a] = point.shape[a] * round_part;
      }
    }

    /// @return false: turned inside out
    bool set_logarithmic_strain(const unsigned int p)
    {
      const SolidPoint &point = points_[first_ + p];
      const Deformation &F = motion_.now(first_ + p);
      const auto &f = F.f;
      const double in_j = f[0] * f[3] - f[1] * f[2];
      if (!(in_j > 0) || !(F.hoop > 0))
        return false;
      const double inverse = 1. / in_j, around = (axisymmetric_ ? 1. / point.radius : 0.) / F.hoop;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        g_[p].r[a] = inverse * (f[3] * point.gradient_r[a] - f[2] * point.gradient_z[a]);
        g_[p].z[a] = inverse * (f[0] * point.gradient_z[a] - f[1] * point.gradient_r[a]);
        g_[p].t[a] = around * point.shape[a];
      }
      const auto &cp = motion_.plastic_metric(first_ + p);
      b_[p].xx = f[0] * f[0] * cp[0] + 2 * f[0] * f[1] * cp[3] + f[1] * f[1] * cp[1];
      b_[p].yy = f[2] * f[2] * cp[0] + 2 * f[2] * f[3] * cp[3] + f[3] * f[3] * cp[1];
      b_[p].xy = f[0] * f[2] * cp[0] + (f[0] * f[3] + f[1] * f[2]) * cp[3] + f[1] * f[3] * cp[1];
      b_[p].zz = F.hoop * F.hoop * cp[2];
      Mandel e = LogarithmicStrain::strain(b_[p]);
      volumetric_[p] = std::log(in_j * F.hoop);
      const Mandel plastic = material_.plastic_strain(first_ + p);
      for (unsigned int k = 0; k < 4; ++k)
        e[k] += plastic[k]; // the material subtracts it
      material_.strain(first_ + p) = e;
      return true;
    }

    const SolidDiscretization &body_;
    const SolidSpace &space_;
    const SolidPoints &points_;
    MaterialPoints &material_;
    SolidMotion &motion_;
    bool axisymmetric_, finite_;

    std::size_t first_ = 0; ///< point of the cell
    const double *project_ = nullptr; ///< from points to points, row-major
    std::array<DofIndex, n_dofs> dofs_;
    std::array<double, n_dofs> u_, residual_;
    std::array<double, n_dofs * n_dofs> matrix_;
    std::array<double, 5> h_; ///< gradient of the displacement at the point at hand: rr, rz, zr, zz, tt
    std::array<double, n_points> volumetric_, weight_;
    std::array<AxialTensor, n_points> b_;
    std::array<double, 16 * n_points> moduli_;
    typename Tangent::AllGradients g_;
    std::array<typename Tangent::Stress, n_points> stress_;
    Tangent derivative_;
    LogarithmicStrain::Rate small_{};
  };
} // namespace deltaform
