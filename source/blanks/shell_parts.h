#pragma once

#include "elastic_core.h"
#include "material_points.h"
#include "shell_points.h"
#include "shell_space.h"
#include "shell_state.h"
#include "shell_surface.h"
#include "shell_transfer.h"

#include <deltaform/io/keyed_arrays.h>

namespace deltaform
{
  /// The parts of a shell that hang on its mesh: their state as one value, and another mesh for all of them.
  class ShellParts
  {
  public:
    ShellParts(ShellSpace &space, ShellPoints &points, ShellState &state, ShellSurface &surface,
               MaterialPoints &material, ElasticCore &core)
      : space_(space), points_(points), state_(state), surface_(surface), material_(material), core_(core)
    {
    }

    const ShellSpace &space() const
    {
      return space_;
    }

    const ShellPoints &points() const
    {
      return points_;
    }

    const ShellState &state() const
    {
      return state_;
    }

    ShellSurface &surface()
    {
      return surface_;
    }

    const MaterialPoints &material() const
    {
      return material_;
    }

    /// The state, with or without the areas and lengths of the contact points, which follow from where these are.
    KeyedArrays whole_state() const;
    KeyedArrays state_of_metal() const;

    void set_state(const KeyedArrays &state);

    /// Take another mesh: all is that of a new shell until set_state().
    void set_mesh(ShellMesh mesh);

    /// From a formed shell on another mesh, see ShellTransfer::describe(). @return the unknowns
    Vector come_over(const ShellTransfer &transfer, const KeyedArrays &formed);

  private:
    ShellSpace &space_;
    ShellPoints &points_;
    ShellState &state_;
    ShellSurface &surface_;
    MaterialPoints &material_;
    ElasticCore &core_;
  };
} // namespace deltaform
