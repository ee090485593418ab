#pragma once

#include "shell_space.h"
#include "shell_surface.h"

#include <deltaform/blanks/boundary.h>

namespace deltaform
{
  /// The two ends of a shell, and its area as loads see it.
  class ShellBoundary : public Boundary
  {
  public:
    /// @p thickness: initial (length)
    ShellBoundary(const ShellSpace &space, const ShellSurface &surface, const double thickness)
      : space_(space), surface_(surface), thickness_(thickness)
    {
    }

    std::vector<std::string> parts() const override;
    std::vector<DofIndex> dofs(const std::string &part, Component component) const override;
    std::vector<Point2> points(const std::string &part) const override;
    std::vector<double> weights(const std::string &part) const override;
    std::vector<std::string> faces() const override;
    std::vector<unsigned int> face_nodes(const std::string &face) const override;
    void assemble_pressure(const Vector &q,
                           const std::string &face,
                           double pressure,
                           bool following,
                           AssemblyTarget &target) const override;
    std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const override;
    std::vector<std::vector<LineNode>> lines() const override;

  private:
    using Residual = std::array<double, 9>;
    using Matrix = std::array<double, 81>;

    /// The node of a part. @throws std::invalid_argument
    unsigned int node(const std::string &part) const;

    /// Forces of a pressure on one cell with its nodes at @p x, and if @p tangent their derivatives.
    void cell_pressure(const std::array<Point2, 3> &x,
                       double pressure,
                       bool tangent,
                       Residual &residual,
                       Matrix &matrix) const;

    const ShellSpace &space_;
    const ShellSurface &surface_;
    double thickness_;
  };
} // namespace deltaform
