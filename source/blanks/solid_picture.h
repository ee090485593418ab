#pragma once

#include "material_points.h"
#include "solid_discretization.h"
#include "solid_motion.h"

#include <deltaform/io/drawing.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// The cells of a picture of a solid with their fields: means over the points of what is drawn as one cell.
  class SolidPicture
  {
  public:
    /// The fields are added to @p drawing, still without values.
    SolidPicture(const SolidDiscretization &body,
                 const MaterialPoints &material,
                 const SolidMotion &motion,
                 Drawing &drawing);

    /// The own cells; @p q with hanging nodes.
    void draw_cells(const Vector &q);

  private:
    /// Where the values of a field go.
    using Values = std::vector<double> *;

    Values add(const std::string &name, const std::string &unit, unsigned int n_components);

    /// @p n_points of a cell, from @p first on.
    void draw_part(const Vector &q, unsigned int cell, unsigned int first, unsigned int n_points);

    /// Mean over points of what else the law remembers (a tensor: rr, zz, hoop, rz).
    std::vector<double> remembered(const HistoryField &field, unsigned int first_point, unsigned int n_points) const;

    const SolidDiscretization &body_;
    const MaterialPoints &material_;
    const SolidMotion &motion_;
    Drawing &drawing_;
    Values equivalent_, von_mises_, mean_, pressure_, strain_, plastic_;
    std::array<Values, 4> stress_;
    std::vector<std::pair<HistoryField, Values>> further_; ///< what else the law remembers
    std::vector<Values> criteria_values_; ///< by criteria
  };
} // namespace deltaform
