#pragma once

#include "elastic_core.h"
#include "material_points.h"
#include "shell_points.h"
#include "shell_space.h"
#include "shell_state.h"

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/status.h>

namespace deltaform
{
  /// Internal forces and tangent of the cells of a shell: doc/theory/shell.md. They bring the material into the trial
  /// state.
  class ShellKernel
  {
  public:
    ShellKernel(const ShellSettings &settings,
                const ShellSpace &space,
                const ShellPoints &points,
                const ShellState &state,
                MaterialPoints &material,
                const ElasticCore &core)
      : shear_factor_(settings.shear_factor), space_(space), points_(points), state_(state), material_(material),
        core_(core)
    {
    }

    /// See Blank::assemble().
    Status assemble(const Vector &q, AssemblyTarget &target);

    /// Transverse shear force per length over the angle of shear; none of a membrane.
    double shear_stiffness() const;

  private:
    template <unsigned int n_nodes, bool membrane>
    Status assemble_cells(const Vector &q, AssemblyTarget &target);

    double shear_factor_;
    const ShellSpace &space_;
    const ShellPoints &points_;
    const ShellState &state_;
    MaterialPoints &material_;
    const ElasticCore &core_;
  };
} // namespace deltaform
