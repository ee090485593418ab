#pragma once

#include "material_points.h"
#include "solid_discretization.h"

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
   * Where the mesh of a solid is too coarse: committed stresses and equivalent plastic strain against recovered ones,
   * fitted by polynomials on the cells around every vertex and blended between the vertices of a cell (O.C.
   * Zienkiewicz, J.Z. Zhu, Int. J. Numer. Methods Eng. 33 (1992) 1331 and 1365); doc/theory/solid.md.
   */
  ErrorEstimate estimate_error(const SolidDiscretization &body, const MaterialPoints &material);
} // namespace deltaform
