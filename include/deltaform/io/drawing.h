#pragma once

#include <deltaform/assembly/types.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// One field of a drawing.
  struct DrawnField
  {
    std::string name;
    std::string unit;
    bool per_point = true; ///< else per cell
    unsigned int n_components = 1; ///< 1, 2 (a vector) or 4: a symmetric tensor, rr, zz, hoop, rz
    std::vector<double> values; ///< the components of the first point, of the second, ...
  };

  /// What results write for ParaView: lines (2 points per cell) or quadrilaterals (4) in the (r, z) plane, with fields.
  struct Drawing
  {
    unsigned int points_per_cell = 4;
    std::vector<Point2> points;
    std::vector<unsigned int> cells; ///< points_per_cell numbers per cell, counterclockwise
    std::vector<DrawnField> fields;
  };
} // namespace deltaform
