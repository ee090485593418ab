#pragma once

#include "solid_space.h"

#include <array>
#include <vector>

namespace deltaform
{
  /// In-plane block (row-major: rr, rz, zr, zz) and hoop stretch of a deformation gradient.
  struct Deformation
  {
    std::array<double, 4> f{{1, 0, 0, 1}};
    double hoop = 1;
  };

  /// What stays the same at a quadrature point of a solid.
  struct SolidPoint
  {
    std::array<double, 9> shape{}, gradient_r{}, gradient_z{}; ///< N_a, dN_a/dR, dN_a/dZ
    double radius = 1; ///< R (plane strain: 1)
    double weight = 0; ///< volume: 2 pi R dA (plane strain: dA)
    Tensor1 across; ///< from bottom to top of a strip, of any length; of another body without meaning
  };

  /// The quadrature points of the own cells, cell by cell, and what is interpolated at or summed over them.
  class SolidPoints
  {
  public:
    explicit SolidPoints(const SolidSpace &space)
      : space_(space)
    {
    }

    /// Shape functions of all points, where the nodes of the space are now.
    void set_up();

    const SolidPoint &operator[](const std::size_t point) const
    {
      return points_[point];
    }

    unsigned int size() const
    {
      return points_.size();
    }

    unsigned int per_cell() const
    {
      return unit_points_.size();
    }

    /// In the unit cell.
    const std::vector<Point2> &unit_points() const
    {
      return unit_points_;
    }

    /// Projection of the volumetric strain of a cell, row-major from points to points: least squares by volume on 1
    /// (degree 1) or 1, xi, eta (degree 2).
    const double *projection(const unsigned int cell) const
    {
      return &projection_[std::size_t(cell) * per_cell() * per_cell()];
    }

    /// Deformation at point @p point of a cell; @p u with hanging nodes.
    Deformation deformation(const Vector &u, unsigned int cell, unsigned int point) const;

    /// Where a point of the whole blank is in the undeformed body.
    Point2 place(unsigned int point) const;

    /// Average at the nodes over the adjacent points of all processes, by volume.
    std::vector<double> to_nodes(const std::vector<double> &point_values) const;

    /// Shares of the initial volume of the unknowns of component @p k: 0 for r, 1 for z.
    std::vector<std::pair<DofIndex, double>> volume_weights(unsigned int k) const;

  private:
    /// Values and gradients of the shape functions at a point of the unit cell, and its weight.
    struct UnitPoint
    {
      std::array<double, 9> shape{};
      std::array<Tensor1, 9> gradient;
      double weight = 0;
    };

    SolidPoint make_point(const SolidSpace::Cell &cell, const UnitPoint &unit) const;

    /// Of the cell whose points are the last ones.
    void add_projection();

    const SolidSpace &space_;
    std::vector<Point2> unit_points_;
    std::vector<SolidPoint> points_;
    std::vector<double> projection_;
  };
} // namespace deltaform
