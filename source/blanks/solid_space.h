#pragma once

#include "hanging_nodes.h"
#include "solid_mesh.h"

#include <deltaform/assembly/types.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * Displacements of a solid: its mesh with quadrilaterals of degree 1 or 2, nodes and the numbers of u_r and u_z.
   * Nodes are known to all processes, under the same numbers; cells to the process that owns them.
   */
  class SolidSpace
  {
  public:
    /// Nodes: corners, middles of the edges, centre.
    using Cell = std::array<unsigned int, 9>;

    /// The places of the nodes of every cell, in the order of its shape functions.
    using CellPlaces = std::function<Point2(unsigned int cell, unsigned int node)>;

    /// Read the mesh.
    SolidSpace(Section &section, unsigned int degree, bool axisymmetric);

    /// Number nodes and unknowns. @p places: where the nodes of the undeformed body are; empty: where the mesh says.
    void set_up(const CellPlaces &places = {});

    unsigned int degree() const
    {
      return degree_;
    }

    bool axisymmetric() const
    {
      return axisymmetric_;
    }

    const SolidMesh &mesh() const
    {
      return mesh_;
    }

    dealii::Triangulation<2> &triangulation()
    {
      return mesh_.triangulation();
    }

    const dealii::DoFHandler<2> &dof_handler() const
    {
      return dof_handler_;
    }

    unsigned int n_nodes_per_cell() const
    {
      return n_nodes_per_cell_;
    }

    /// Of this process, in the order of the mesh.
    const std::vector<Cell> &cells() const
    {
      return cells_;
    }

    /// Undeformed.
    const std::vector<Point2> &nodes() const
    {
      return nodes_;
    }

    /// Of a node in the triangulation.
    const Point2 &parameter(const unsigned int node) const
    {
      return parameters_[node];
    }

    /// Strip: number of the node's column. Nodes of refined cells lie at binary fractions.
    long cross_section(const unsigned int node) const
    {
      return std::lround((1 << 20) * parameters_[node][0]);
    }

    /// Numbers of u_r and u_z of every node; those of hanging nodes come after all unknowns.
    const std::vector<std::array<DofIndex, 2>> &dofs() const
    {
      return dofs_;
    }

    const HangingNodes &hanging() const
    {
      return hanging_;
    }

    /// Where a node is; @p q with hanging nodes if it may be one.
    Point2 position(const Vector &q, const unsigned int node) const
    {
      return nodes_[node] + Tensor1({q[dofs_[node][0]], q[dofs_[node][1]]});
    }

    /// Of all nodes; @p q of the unknowns.
    std::vector<Point2> positions(const Vector &q) const;

    /// Enter the couplings that the own cells make.
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    /// u_r of the nodes on the axis.
    std::vector<DofIndex> axis_dofs() const;

    /// "node 12 (R0 = 0.53, Z0 = 0), u_r".
    std::string describe(DofIndex dof) const;

    /// See Blank::rigid_motion().
    void rigid_motion(const Vector &q,
                      const Tensor1 &translation,
                      double rotation,
                      const std::function<void(DofIndex, double)> &set) const;

  private:
    void number_serial(const std::vector<DofIndex> &number, const CellPlaces &places);
    void number_distributed(const std::vector<DofIndex> &number, const CellPlaces &places);

    unsigned int degree_, n_nodes_per_cell_;
    bool axisymmetric_;
    SolidMesh mesh_;
    std::unique_ptr<dealii::FESystem<2>> element_;
    dealii::DoFHandler<2> dof_handler_;
    HangingNodes hanging_;
    std::vector<Cell> cells_;
    std::vector<Point2> nodes_, parameters_;
    std::vector<std::array<DofIndex, 2>> dofs_;
  };
} // namespace deltaform
