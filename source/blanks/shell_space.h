#pragma once

#include "shell_mesh.h"
#include "shell_settings.h"

#include <deltaform/assembly/types.h>
#include <deltaform/blanks/element_chain.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// Displacements of a shell: elements of degree 1 or 2 on its meridian, and the numbers of u_r, u_z and the rotation
  /// of every node.
  class ShellSpace
  {
  public:
    /// Point of the quadrature of loads and areas: shape functions, their derivatives on the unit cell, weight.
    struct LoadPoint
    {
      std::array<double, 3> shape{}, gradient{};
      double weight = 0;
    };

    /// Read the mesh and number the unknowns.
    ShellSpace(Section &section, const ShellSettings &settings);

    unsigned int degree() const
    {
      return degree_;
    }

    unsigned int n_nodes_per_cell() const
    {
      return degree_ + 1;
    }

    bool axisymmetric() const
    {
      return axisymmetric_;
    }

    /// No bending: rotations are fixed.
    bool membrane() const
    {
      return membrane_;
    }

    /// Take another mesh of the same meridian, and number the unknowns anew.
    void set_mesh(ShellMesh mesh);

    const ShellMesh &mesh() const
    {
      return mesh_;
    }

    unsigned int n_nodes() const
    {
      return dofs_.size();
    }

    unsigned int n_dofs() const
    {
      return dof_handler_.n_dofs();
    }

    /// u_r, u_z and rotation of every node.
    const std::vector<std::array<DofIndex, 3>> &dofs() const
    {
      return dofs_;
    }

    const ElementChain &chain() const
    {
      return chain_;
    }

    bool is_rotation(const DofIndex dof) const
    {
      return is_rotation_[dof];
    }

    const std::vector<LoadPoint> &load_quadrature() const
    {
      return load_quadrature_;
    }

    Point2 position(const Vector &q, const unsigned int node) const
    {
      return mesh_.nodes()[node] + Tensor1({q[dofs_[node][0]], q[dofs_[node][1]]});
    }

    std::vector<Point2> positions(const Vector &q) const;

    double rotation(const Vector &q, const unsigned int node) const
    {
      return q[dofs_[node][2]];
    }

    /// Angle of the deformed meridian at a node, by its neighbours (the director of a membrane).
    double chord_angle(const Vector &q, unsigned int node) const;

    /// By how much a cell has bent (degree 2: the half of it that has bent more), positive towards the top (rad).
    double bend(const Vector &q, unsigned int cell) const;

    /// Areas that belong to the nodes at @p q: 2 pi r ds (plane strain: ds), weighted by the shape functions.
    std::vector<double> areas(const Vector &q) const;

    void add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    /// u_r and rotations of the nodes on the axis, all rotations of a membrane.
    std::vector<DofIndex> fixed_dofs() const;

    /// "node 12 (R0 = 0.53, Z0 = 0), u_r".
    std::string describe(DofIndex dof) const;

    /// See Blank::rigid_motion() and Blank::admissible_step().
    void rigid_motion(const Vector &q,
                      const Tensor1 &translation,
                      double rotation,
                      const std::function<void(DofIndex, double)> &set) const;
    double admissible_step(const Vector &q, const Vector &dq) const;

  private:
    void number();
    void link();
    void set_up_load_quadrature();

    unsigned int degree_;
    bool axisymmetric_, membrane_;
    double thickness_;
    ShellMesh mesh_;
    dealii::Triangulation<1, 2> triangulation_;
    std::unique_ptr<dealii::FESystem<1, 2>> element_;
    dealii::DoFHandler<1, 2> dof_handler_;
    std::vector<std::array<DofIndex, 3>> dofs_;
    std::vector<bool> is_rotation_;
    ElementChain chain_;
    std::vector<LoadPoint> load_quadrature_;
  };
} // namespace deltaform
