#pragma once

#include "solid_discretization.h"
#include "solid_surface.h"

#include <deltaform/io/table.h>

#include <array>
#include <vector>

namespace deltaform
{
  /**
   * Table of the accepted state along a solid. Of a strip: its middle line, one row per column of nodes that goes
   * through from bottom to top. Of another body: the nodes that tools can touch, bottom first.
   */
  class SolidProfile
  {
  public:
    /// @p q with hanging nodes.
    SolidProfile(const SolidDiscretization &body,
                 const SolidSurface &surface,
                 const MaterialPoints &material,
                 const Vector &q);

    Table table() const;

  private:
    /// Nodes of one row, from bottom to top.
    using Group = std::vector<unsigned int>;

    void collect_groups();

    /// Half way between bottom and top of a row.
    Point2 middle(const Group &nodes, bool deformed) const;

    /// From the row before to the row after: along the middle line.
    Tensor1 along(unsigned int group, bool deformed) const;

    double hoop_strain(unsigned int group) const;

    /// To the other side; where tools touch one side only there is none but the one that is read.
    double thickness(unsigned int group) const;
    double thickness_strain(unsigned int group) const;

    /// Over the thickness.
    double mean(const std::vector<double> &values, const Group &nodes) const;

    std::vector<double> row(unsigned int group, double arc) const;

    const SolidSpace &space_;
    const SolidSurface &surface_;
    const Vector &q_;
    std::vector<Group> groups_;
    std::vector<double> plastic_; ///< equivalent plastic strain of the nodes
    const PointCriteria &criteria_;
    std::vector<std::vector<double>> criteria_values_; ///< of the nodes, by criteria
    std::array<std::vector<double>, 4> stress_; ///< of the nodes: rr, zz, hoop, rz
  };
} // namespace deltaform
