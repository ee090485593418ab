#pragma once

#include "material_points.h"
#include "solid_discretization.h"

#include <deltaform/blanks/fields.h>

#include <vector>

namespace deltaform
{
  /// How far the stresses of a solid are from smooth ones.
  struct ErrorEstimate
  {
    std::vector<double> squares; ///< squared error in energy of every own cell (force*length)
    double relative = 0; ///< error in energy of the whole body over its energy
  };


  /**
   * Where the mesh of a solid is too coarse: committed stresses and equivalent plastic strain against recovered ones
   * (SolidRecovery); doc/theory/solid.md, Refinement during the run.
   */
  ErrorEstimate estimate_error(const SolidDiscretization &body, const MaterialPoints &material);


  /**
   * Does the mesh resolve how the metal flows? Plastic work of the last increment, and the integral of |dt : de|, the
   * differences of stresses and plastic strains to recovered ones (L. Fourment, J.L. Chenot, Eng. Comput. 12 (1995)
   * 469, for rates); doc/theory/solid.md, Is the mesh fine enough?
   * @param flow plastic strain of the last increment, of every own point
   */
  MeshError error_of_flow(const SolidDiscretization &body,
                          const MaterialPoints &material,
                          const std::vector<Mandel> &flow);
} // namespace deltaform
