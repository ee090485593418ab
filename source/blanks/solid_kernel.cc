// Internal forces and tangent of the solid: derivation in doc/theory/solid.md.
#include "solid_kernel.h"
#include "solid_cell.h"

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
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
    motion_.reset(n, material_.has_predictor());
    linear_ = has_linear_law();
    turn_axes();
  }


  MetalAxes axes_of(const SolidDiscretization &body, const bool finite, const std::size_t point, const Deformation &F)
  {
    // Axis 1 is at right angles to the direction across, clockwise; the angles of both complex numbers add up.
    const bool strip = body.space().mesh().is_strip();
    const Tensor1 &across = body.points()[point].across;
    const double c0 = strip ? across[1] : 1., s0 = strip ? -across[0] : 0.;
    if (!finite)
      return MetalAxes(c0, s0);
    const double c = F.f[0] + F.f[3], s = F.f[2] - F.f[1];
    return MetalAxes(c * c0 - s * s0, c * s0 + s * c0);
  }


  void SolidKernel::turn_axes()
  {
    if (!material_.has_axes())
      return;
    for (std::size_t i = 0; i < material_.size(); ++i)
      material_.set_axes(i, axes_of(body_, motion_.finite(), i, motion_.now(i)));
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
    const SolidSpace &space = body_.space();
    const bool tangent = target.wants_tangent();
    Vector storage;
    const Vector &values = space.hanging().with_hanging(q, storage);
    if (linear_ && tangent)
      constant_matrices_.clear();
    SolidCell<n_nodes, n_points> cell(body_, material_, motion_);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
    {
      cell.enter(c, values);
      if (!cell.set_strains())
        return Status::shorten("a cell of the solid is turned inside out", c);
      cell.project_strains();
      if (Status status = cell.update_stresses(tangent); !status.good())
      {
        status.place = c;
        return status;
      }
      cell.set_forces();
      if (tangent)
        cell.set_tangent();
      if (linear_ && tangent)
        constant_matrices_.insert(constant_matrices_.end(), cell.matrix().begin(), cell.matrix().end());
      space.hanging().add(target, cell.dofs().data(), cell.n_dofs, tangent ? cell.matrix().data() : nullptr,
                          cell.residual().data());
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
