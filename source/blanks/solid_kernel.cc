// Internal forces and tangent of the solid: derivation in doc/theory/solid.md.
#include "solid_kernel.h"
#include "solid_tangent.h"

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/kinematics/logarithmic_strain.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_half = .70710678118654752440;

    /// For a pass over the cells whose forces nobody wants.
    class Nowhere : public AssemblyTarget
    {
    public:
      explicit Nowhere(const bool tangent)
        : tangent_(tangent)
      {
      }
      void add(const DofIndex *, unsigned int, const double *, const double *) override
      {
      }
      bool wants_tangent() const override
      {
        return tangent_;
      }

    private:
      bool tangent_;
    };
  } // namespace


  void SolidKernel::reset()
  {
    const unsigned int n = body_.points().size();
    constant_matrices_.clear();
    material_.reset(n);
    motion_.reset(n, material_.carries());
    linear_ = has_linear_law();
    turn_axes();
  }


  MetalAxes SolidKernel::axes(const std::size_t point, const Deformation &F) const
  {
    // Axis 1 is at right angles to the direction across, clockwise; the angles of both complex numbers add up.
    const bool strip = body_.space().mesh().is_strip();
    const Tensor1 &across = body_.points()[point].across;
    const double c0 = strip ? across[1] : 1., s0 = strip ? -across[0] : 0.;
    if (!motion_.finite())
      return MetalAxes(c0, s0);
    const double c = F.f[0] + F.f[3], s = F.f[2] - F.f[1];
    return MetalAxes(c * c0 - s * s0, c * s0 + s * c0);
  }


  void SolidKernel::turn_axes()
  {
    if (!material_.has_axes())
      return;
    for (std::size_t i = 0; i < material_.size(); ++i)
      material_.set_axes(i, axes(i, motion_.now(i)));
  }


  bool SolidKernel::has_linear_law() const
  {
    if (motion_.finite() || material_.plastic())
      return false;
    std::array<Mandel, 2> strain{{{}, {{1e-3, -2e-3, 5e-4, 7e-4}}}}, stress;
    std::array<double, 32> moduli;
    MaterialBatch batch;
    batch.n_points = 2;
    batch.strain = strain.data();
    batch.stress = stress.data();
    batch.tangent = moduli.data();
    const bool good = material_.law().update(batch).good();
    return good && std::equal(moduli.begin(), moduli.begin() + 16, moduli.begin() + 16);
  }


  template <unsigned int n_nodes, unsigned int n_points>
  Status SolidKernel::assemble_cells(const Vector &q, AssemblyTarget &target)
  {
    constexpr unsigned int n = 2 * n_nodes;
    const SolidSpace &space = body_.space();
    const SolidPoints &points = body_.points();
    const bool axisymmetric = space.axisymmetric(), finite = motion_.finite();
    const bool tangent = target.wants_tangent();
    std::array<DofIndex, n> dofs;
    std::array<double, n> residual, u;
    std::array<double, n * n> matrix;
    std::array<double, n_points> volumetric, mean, weight;
    std::array<AxialTensor, n_points> b;
    std::array<double, 16 * n_points> moduli;
    using Tangent = SolidTangent<n_nodes, n_points>;
    typename Tangent::AllGradients g;
    std::array<typename Tangent::Stress, n_points> stress;
    Tangent derivative(g);
    // The strain of small kinematics is the symmetric part of the gradient.
    LogarithmicStrain::Rate small{};
    small[0][0] = small[1][3] = small[2][4] = 1.;
    small[3][1] = small[3][2] = root_half;

    Vector storage;
    const Vector &values = space.hanging().with_hanging(q, storage);
    if (linear_ && tangent)
      constant_matrices_.clear();
    for (unsigned int c = 0; c < space.cells().size(); ++c)
    {
      const auto &cell = space.cells()[c];
      const unsigned int first = c * n_points;
      const double *project = points.projection(c);
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 2; ++k)
        {
          dofs[2 * a + k] = space.dofs()[cell[a]][k];
          u[2 * a + k] = values[dofs[2 * a + k]];
        }

      // Trial elastic strain of all points
      for (unsigned int p = 0; p < n_points; ++p)
      {
        const SolidPoint &point = points[first + p];
        double h_rr = 0, h_rz = 0, h_zr = 0, h_zz = 0, h_tt = 0;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          h_rr += point.gradient_r[a] * u[2 * a];
          h_rz += point.gradient_z[a] * u[2 * a];
          h_zr += point.gradient_r[a] * u[2 * a + 1];
          h_zz += point.gradient_z[a] * u[2 * a + 1];
          h_tt += point.shape[a] * u[2 * a];
        }
        h_tt = axisymmetric ? h_tt / point.radius : 0.;
        Deformation &F = motion_.now(first + p);
        F.f = {{1. + h_rr, h_rz, h_zr, 1. + h_zz}};
        F.hoop = 1. + h_tt;
        if (material_.has_axes())
          material_.set_axes(first + p, axes(first + p, F));
        const double round_part = axisymmetric ? 1. / point.radius : 0.;
        Mandel &e = material_.strain(first + p);
        if (!finite)
        {
          e = {{h_rr, h_zz, h_tt, root_half * (h_rz + h_zr)}};
          volumetric[p] = h_rr + h_zz + h_tt;
          for (unsigned int a = 0; a < n_nodes; ++a)
          {
            g[p].r[a] = point.gradient_r[a];
            g[p].z[a] = point.gradient_z[a];
            g[p].t[a] = point.shape[a] * round_part;
          }
          continue;
        }
        const auto &f = F.f;
        const double in_j = f[0] * f[3] - f[1] * f[2];
        if (!(in_j > 0) || !(F.hoop > 0))
          return Status::shorten("a cell of the solid is turned inside out", c);
        const double inverse = 1. / in_j, around = round_part / F.hoop;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          g[p].r[a] = inverse * (f[3] * point.gradient_r[a] - f[2] * point.gradient_z[a]);
          g[p].z[a] = inverse * (f[0] * point.gradient_z[a] - f[1] * point.gradient_r[a]);
          g[p].t[a] = around * point.shape[a];
        }
        const auto &cp = motion_.plastic_metric(first + p);
        b[p].xx = f[0] * f[0] * cp[0] + 2 * f[0] * f[1] * cp[3] + f[1] * f[1] * cp[1];
        b[p].yy = f[2] * f[2] * cp[0] + 2 * f[2] * f[3] * cp[3] + f[3] * f[3] * cp[1];
        b[p].xy = f[0] * f[2] * cp[0] + (f[0] * f[3] + f[1] * f[2]) * cp[3] + f[1] * f[3] * cp[1];
        b[p].zz = F.hoop * F.hoop * cp[2];
        e = LogarithmicStrain::strain(b[p]);
        volumetric[p] = std::log(in_j * F.hoop);
        const Mandel plastic = material_.plastic_strain(first + p);
        for (unsigned int k = 0; k < 4; ++k)
          e[k] += plastic[k]; // the material subtracts it
      }
      for (unsigned int p = 0; p < n_points; ++p)
      {
        double projected = 0;
        for (unsigned int k = 0; k < n_points; ++k)
          projected += project[p * n_points + k] * volumetric[k];
        for (unsigned int k = 0; k < 3; ++k)
          material_.strain(first + p)[k] += (projected - volumetric[p] - motion_.volume_offset(first + p)) / 3.;
      }

      Status status = material_.update(first, n_points, tangent ? moduli.data() : nullptr);
      if (!status.good())
      {
        status.place = c;
        return status;
      }

      for (unsigned int p = 0; p < n_points; ++p)
        mean[p] = (material_.stress(first + p)[0] + material_.stress(first + p)[1] +
                   material_.stress(first + p)[2]) /
                  3.;
      residual.fill(0.);
      for (unsigned int p = 0; p < n_points; ++p)
      {
        // The stress that does work: deviator here, projected mean stress
        const Mandel &tau = material_.stress(first + p);
        const double w = points[first + p].weight;
        double shift = -mean[p];
        for (unsigned int k = 0; k < n_points; ++k)
          shift += project[p * n_points + k] * mean[k];
        const double t_rr = w * (tau[0] + shift), t_zz = w * (tau[1] + shift), t_tt = w * (tau[2] + shift);
        const double t_rz = w * root_half * tau[3];
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          residual[2 * a] += t_rr * g[p].r[a] + t_rz * g[p].z[a] + t_tt * g[p].t[a];
          residual[2 * a + 1] += t_rz * g[p].r[a] + t_zz * g[p].z[a];
        }
        weight[p] = w;
        if (finite)
          stress[p] = {t_rr, t_zz, t_tt, t_rz};
      }
      if (tangent)
      {
        derivative.project_volume(project);
        for (unsigned int p = 0; p < n_points; ++p)
        {
          derivative.set_stress_rate(p, &moduli[16 * p], finite ? LogarithmicStrain::rate(b[p]) : small);
          if (finite && material_.has_axes())
            derivative.add_turning(p, material_.stress_by_angle(first + p), motion_.now(first + p).f);
        }
        derivative.assemble(project, weight, stress, matrix.data());
      }
      if (linear_ && tangent)
        constant_matrices_.insert(constant_matrices_.end(), matrix.begin(), matrix.end());
      space.hanging().add(target, dofs.data(), n, tangent ? matrix.data() : nullptr, residual.data());
    }
    return {};
  }


  Status SolidKernel::assemble(const Vector &q, AssemblyTarget &target)
  {
    return ranks::worst(assemble_own_cells(q, target));
  }


  Status SolidKernel::assemble_own_cells(const Vector &q, AssemblyTarget &target)
  {
    if (!linear_)
      return assemble_all(q, target);
    if (constant_matrices_.empty())
    {
      // Also where a run is resumed: the forces are those of the matrices from the first iteration on, to the last
      // digit.
      Nowhere nowhere(true);
      const Status status = assemble_all(q, nowhere);
      if (!status.good())
        return status;
    }
    return assemble_constant(q, target);
  }


  Status SolidKernel::assemble_all(const Vector &q, AssemblyTarget &target)
  {
    return body_.space().degree() == 1 ? assemble_cells<4, 4>(q, target) : assemble_cells<9, 9>(q, target);
  }


  Status SolidKernel::assemble_constant(const Vector &q, AssemblyTarget &target) const
  {
    const SolidSpace &space = body_.space();
    const unsigned int n = 2 * space.n_nodes_per_cell();
    std::array<DofIndex, 18> dofs;
    std::array<double, 18> u, residual;
    Vector storage;
    const Vector &values = space.hanging().with_hanging(q, storage);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
    {
      const double *matrix = &constant_matrices_[c * n * n];
      for (unsigned int i = 0; i < n; ++i)
      {
        dofs[i] = space.dofs()[space.cells()[c][i / 2]][i % 2];
        u[i] = values[dofs[i]];
      }
      for (unsigned int i = 0; i < n; ++i)
      {
        residual[i] = 0.;
        for (unsigned int j = 0; j < n; ++j)
          residual[i] += matrix[i * n + j] * u[j];
      }
      space.hanging().add(target, dofs.data(), n, target.wants_tangent() ? matrix : nullptr, residual.data());
    }
    return {};
  }


  void SolidKernel::update_stress(const Vector &q)
  {
    // One more pass over the law, for strains and stresses only: nobody has asked for them on the way.
    Nowhere nowhere(false);
    assemble_all(q, nowhere);
  }


  double SolidKernel::admissible_step(const Vector &q, const Vector &dq) const
  {
    // |d F F^-1| below one half keeps the determinant positive.
    constexpr double largest_strain = .4;
    const SolidSpace &space = body_.space();
    const SolidPoints &points = body_.points();
    double factor = 1.;
    Vector storage, step_storage;
    const Vector &u = space.hanging().with_hanging(q, storage), &du = space.hanging().with_hanging(dq, step_storage);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
      for (unsigned int p = 0; p < points.per_cell(); ++p)
      {
        const Deformation F = points.deformation(u, c, p), G = points.deformation(du, c, p);
        const std::array<double, 4> h{{G.f[0] - 1., G.f[1], G.f[2], G.f[3] - 1.}};
        const double inverse = 1. / (F.f[0] * F.f[3] - F.f[1] * F.f[2]);
        const double l[4] = {inverse * (h[0] * F.f[3] - h[1] * F.f[2]),
                             inverse * (h[1] * F.f[0] - h[0] * F.f[1]),
                             inverse * (h[2] * F.f[3] - h[3] * F.f[2]),
                             inverse * (h[3] * F.f[0] - h[2] * F.f[1])};
        const double size = std::sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2] + l[3] * l[3]);
        factor = std::min(factor, largest_strain / std::max({size, std::abs(G.hoop - 1.) / F.hoop, 1e-300}));
      }
    return ranks::min(factor);
  }
} // namespace deltaform
