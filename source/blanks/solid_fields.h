#pragma once

#include "solid_discretization.h"
#include "solid_motion.h"
#include "solid_surface.h"

#include <deltaform/blanks/fields.h>

#include <vector>

namespace deltaform
{
  /// What can be seen of the accepted state of a solid. All processes together, each with its own cells.
  class SolidFields : public Fields
  {
  public:
    SolidFields(const SolidDiscretization &body,
                const SolidSurface &surface,
                const MaterialPoints &material,
                const SolidMotion &motion,
                const std::vector<Mandel> &flow)
      : body_(body), surface_(surface), material_(material), motion_(motion), flow_(flow)
    {
    }

    Table profile(const Vector &q) const override;
    Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const override;
    double smallest_thickness() const override;
    std::vector<LargestCriterion> largest_criteria() const override;
    SharpestBend sharpest_bend(const Vector &q) const override;
    InnermostPlace innermost_place(const Vector &q) const override;
    FoldedCells folded_cells(const Vector &q) const override;
    MeshError mesh_error(const Vector &q) const override;

  private:
    const SolidDiscretization &body_;
    const SolidSurface &surface_;
    const MaterialPoints &material_;
    const SolidMotion &motion_;
    const std::vector<Mandel> &flow_; ///< plastic strain of the last increment, of every own point; none if unknown
  };
} // namespace deltaform
