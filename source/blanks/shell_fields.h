#pragma once

#include "material_points.h"
#include "shell_kernel.h"
#include "shell_points.h"
#include "shell_space.h"
#include "shell_state.h"
#include "shell_surface.h"

#include <deltaform/blanks/fields.h>

namespace deltaform
{
  /// What can be seen of the accepted state of a shell.
  class ShellFields : public Fields
  {
  public:
    ShellFields(const ShellSpace &space,
                const ShellPoints &points,
                const ShellState &state,
                const ShellSurface &surface,
                const MaterialPoints &material,
                const ShellKernel &kernel)
      : space_(space), points_(points), state_(state), surface_(surface), material_(material), kernel_(kernel)
    {
    }

    Table profile(const Vector &q) const override;
    Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const override;
    double smallest_thickness() const override;
    bool is_sheet() const override;
    std::vector<SheetSection> sections() const override;
    SharpestBend sharpest_bend(const Vector &q) const override;
    LargestShear largest_shear(const Vector &q) const override;
    Overlap overlap(const Vector &q) const override;
    InnermostPlace innermost_place(const Vector &q) const override;
    std::vector<LargestCriterion> largest_criteria() const override;

  private:
    /// Columns of the profile from the points, averaged at the nodes, see profile().
    std::vector<std::vector<double>> averages() const;

    /// Mean over the thickness at a point of the meridian.
    double flow_stress(unsigned int point) const;

    /// Mean flow stress over the thickness where tools press a section on both faces.
    void add_flow_stress(std::vector<SheetSection> &sections) const;

    /// Criterion @p k of the cross-section at a point of the meridian.
    double criterion(unsigned int point, unsigned int k) const;

    /// The cells of a picture, by layers, with their fields.
    void draw_cells(const Vector &q, Drawing &drawing) const;

    /// The criteria of the scene in the same cells.
    void draw_criteria(std::size_t n_cells, Drawing &drawing) const;

    const ShellSpace &space_;
    const ShellPoints &points_;
    const ShellState &state_;
    const ShellSurface &surface_;
    const MaterialPoints &material_;
    const ShellKernel &kernel_;
  };
} // namespace deltaform
