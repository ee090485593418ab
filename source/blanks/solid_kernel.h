#pragma once

#include "material_points.h"
#include "solid_discretization.h"
#include "solid_motion.h"

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/status.h>

#include <vector>

namespace deltaform
{
  /// Internal forces and tangent of the cells of a solid: doc/theory/solid.md. They bring material and motion into the
  /// trial state.
  class SolidKernel
  {
  public:
    SolidKernel(const SolidDiscretization &body, MaterialPoints &material, SolidMotion &motion)
      : body_(body), material_(material), motion_(motion)
    {
    }

    /// Points that never strained, on the cells as they are now.
    void reset();

    /// Small strain, and moduli that do not depend on the strain: the tangent is always the same.
    bool is_linear() const
    {
      return linear_;
    }

    /// See Blank::assemble(); all processes together.
    Status assemble(const Vector &q, AssemblyTarget &target);

    /// Strains and stresses at @p q, and nothing else.
    void update_stress(const Vector &q);

    /// The matrices of the cells are to be computed anew.
    void discard_matrices()
    {
      constant_matrices_.clear();
    }

    /// Turn the axes of the metal at all points as far as they have moved.
    void turn_axes();

    /// See Blank::admissible_step().
    double admissible_step(const Vector &q, const Vector &dq) const;

  private:
    /// Small strain, a law without history, and the same moduli at zero and at some strain?
    bool has_linear_law() const;

    template <unsigned int n_nodes, unsigned int n_points>
    Status assemble_cells(const Vector &q, AssemblyTarget &target);
    Status assemble_all(const Vector &q, AssemblyTarget &target);

    /// The own cells, whatever other processes find in theirs.
    Status assemble_own_cells(const Vector &q, AssemblyTarget &target);

    /// By the matrices of is_linear(): no law is asked again.
    Status assemble_constant(const Vector &q, AssemblyTarget &target) const;

    const SolidDiscretization &body_;
    MaterialPoints &material_;
    SolidMotion &motion_;
    bool linear_ = false;
    std::vector<double> constant_matrices_; ///< of is_linear(), cell by cell, from the first pass on
  };
} // namespace deltaform
