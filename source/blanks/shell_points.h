#pragma once

#include "shell_space.h"

#include <deltaform/kinematics/shell_strain.h>

#include <array>
#include <vector>

namespace deltaform
{
  class Section;

  /// What stays the same at a quadrature point on the meridian of a shell.
  struct ShellPoint
  {
    std::array<double, 3> shape{}, gradient{}; ///< N_a and dN_a/dS
    double radius = 1; ///< R (plane strain: 1)
    double angle = 0; ///< of the reference tangent
    double angle_prime = 0; ///< reference curvature
    double lambda = 1, gamma = 0; ///< reference values of Lambda and Gamma
    double weight = 0; ///< 2 pi dS (plane strain: dS)
  };


  /**
   * The quadrature points of a shell, cell by cell along the meridian, and its layers through the thickness: material
   * point l of point p has the number p n_layers + l.
   */
  class ShellPoints
  {
  public:
    /// Read how layers are placed.
    ShellPoints(Section &section, const ShellSettings &settings, const ShellSpace &space);

    /// The mesh is another one.
    void set_up();

    const ShellPoint &operator[](const std::size_t point) const
    {
      return points_[point];
    }

    unsigned int size() const
    {
      return points_.size();
    }

    unsigned int per_cell() const
    {
      return n_points_per_cell_;
    }

    unsigned int n_layers() const
    {
      return layer_position_.size();
    }

    /// Distance of a layer from the middle, initial (length).
    double layer_position(const unsigned int layer) const
    {
      return layer_position_[layer];
    }

    /// Share of a layer in the initial thickness (length).
    double layer_weight(const unsigned int layer) const
    {
      return layer_weight_[layer];
    }

    /// Are the kinks at the ends of the elastic core integrated by themselves?
    bool with_elastic_core() const
    {
      return with_elastic_core_;
    }

    /// Shares of the layers in the thickness, which sum to 1.
    std::vector<double> layer_shares() const;

    double thickness() const
    {
      return thickness_;
    }

    /// Where a point is on the undeformed meridian.
    Point2 place(unsigned int point) const;

    /// Reference volume that a layer of a point stands for. @param sine of the angle of the undeformed meridian
    double layer_volume(const ShellPoint &point, const double sine, const unsigned int layer) const
    {
      const double along = point.lambda - layer_position_[layer] * point.angle_prime;
      const double around = space_.axisymmetric() ? point.radius - layer_position_[layer] * sine : 1.;
      return point.weight * layer_weight_[layer] * along * around;
    }

    /// Generalized strain at a point of a cell; @p point by the numbers of the whole shell.
    ShellStrain strain(const Vector &q, unsigned int cell, unsigned int point) const;

    /// Average at the nodes over the adjacent points, by their share of the reference area.
    std::vector<double> to_nodes(const std::vector<double> &point_values) const;

    /**
     * At the two ends of the meridian to_nodes() has the value half an element away from the edge. Continues the values
     * of the last two points to the edge by a straight line. An end on the axis, or in the plane R = 0 of a symmetric
     * strip, keeps its average: what is symmetric has no slope there.
     */
    void to_edges(const std::vector<double> &point_values, std::vector<double> &node_values) const;

    /// What the average divides by: a share of the reference area.
    double node_weight(const unsigned int node) const
    {
      return node_weight_[node];
    }

  private:
    ShellPoint make_point(const ShellMesh::Cell &cell,
                          const std::array<double, 3> &shape,
                          const std::array<double, 3> &gradient,
                          double weight) const;

    const ShellSpace &space_;
    unsigned int n_points_per_cell_;
    double thickness_;
    bool with_elastic_core_ = false;
    std::vector<ShellPoint> points_;
    std::vector<double> layer_position_, layer_weight_, node_weight_;
  };
} // namespace deltaform
