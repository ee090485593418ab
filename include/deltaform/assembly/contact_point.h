#pragma once

#include <deltaform/assembly/types.h>

#include <array>

namespace deltaform
{
  /// The thickness that keeps a tool away from the mid-surface of a shell.
  enum class ContactThickness : unsigned char
  {
    current, ///< of the last accepted increment, so that the tangent stays exact
    initial, ///< for a tool at a fixed gap to another one
    none ///< 0: the tool touches the mid-surface
  };

  /**
   * What contact knows of a point on one side of the blank: its place is a sparse row over unknowns. A node, which its
   * own unknowns move alone, is the special case. Shells and solids look the same.
   */
  struct ContactPoint
  {
    static constexpr unsigned int max_dofs = 6; ///< two nodes of a shell, or three of a solid's edge
    static constexpr unsigned int max_nodes = 3;

    /// A node that carries the point, and its share of what acts there.
    struct Carrier
    {
      unsigned int node = invalid_index; ///< number within the blank
      double share = 0; ///< the shares of a point sum up to 1
    };

    unsigned int n_nodes = 0;
    std::array<Carrier, max_nodes> nodes{};
    unsigned int n_dofs = 0;
    std::array<DofIndex, max_dofs> dofs{}; ///< the displacements of the node with the largest share come first
    Point2 x; ///< current position of the contact point
    std::array<Tensor1, max_dofs> jacobian{}; ///< dx/dq_k
    std::array<Tensor1, max_dofs> second{}; ///< d2x/dq_k2 (mixed derivatives vanish); zero but for rotations
    double offset = 0; ///< distance from x to the face that the tool touches: half the thickness, or 0
    double area = 0; ///< tributary area: of the full circumference, or per unit width
    double compliance = 0; ///< [length/force] through-thickness compliance: d(half thickness)/d(normal force);
      ///< solids: 0
    double recovery = 0; ///< [length] elastic recovery of the face: by how much it would rise if the transverse stress
      ///< of the last increment were removed
    double reference_coordinate = 0; ///< R0, for output and messages
    double thickness = 0; ///< current one, for output and messages
    double arc_coordinate = 0; ///< S0, arc length along the undeformed blank from its start, for output

    /// How far it moves if the unknowns change by @p d and its row is constant, and @p dx beside it.
    Tensor1 motion(const Vector &d, Tensor1 dx) const
    {
      for (unsigned int k = 0; k < n_dofs; ++k)
        dx += d[dofs[k]] * jacobian[k];
      return dx;
    }

    /// A point that is a node.
    void set_node(const unsigned int node)
    {
      n_nodes = 1;
      nodes[0] = {node, 1.};
    }
  };
} // namespace deltaform
