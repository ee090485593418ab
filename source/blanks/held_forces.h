#pragma once

#include "solid_discretization.h"
#include "solid_kernel.h"

#include <deltaform/io/keyed_arrays.h>

#include <optional>

namespace deltaform
{
  /// The forces on the nodes of a solid that hold it in its shape, from one mesh to another one (doc/theory/solid.md).
  class HeldForces
  {
  public:
    HeldForces(const SolidDiscretization &body, SolidKernel &kernel)
      : body_(body), kernel_(kernel)
    {
    }

    /// Put the forces at @p q into a state, with the undeformed places of the nodes. The trial state is that of @p q.
    void describe(const Vector &q, KeyedArrays &formed) const;

    /// The forces that were described, on the unknowns of this mesh: their resultant and their moments are kept, as
    /// they do the same work on the displacements of this mesh at their places. Those on what was trimmed are gone.
    /// @return none if there was no stress that holds a state
    std::optional<Vector> come_over(const KeyedArrays &formed) const;

  private:
    const SolidDiscretization &body_;
    SolidKernel &kernel_;
  };
} // namespace deltaform
