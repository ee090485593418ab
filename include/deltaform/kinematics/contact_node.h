#pragma once

#include <deltaform/base/types.h>

#include <array>

namespace deltaform
{
  /// Which thickness keeps a tool away from the mid-surface of a shell.
  enum class ContactThickness : unsigned char
  {
    current, ///< the last committed one, so that the tangent stays exact
    initial, ///< for a tool with a fixed gap against another
    none
  };

  /**
   * What contact sees of a blank at one node of one side: a point that moves with at most three unknowns. Whether a
   * shell or a solid stands behind it does not show.
   */
  struct ContactNode
  {
    static constexpr unsigned int max_dofs = 3;

    unsigned int node = invalid_index; ///< number of the node within the blank
    unsigned int n_dofs = 0;
    std::array<DofIndex, max_dofs> dofs{};
    Point2 x; ///< current position of the contact point
    std::array<Tensor1, max_dofs> jacobian{}; ///< dx/dq_k
    std::array<Tensor1, max_dofs> second{}; ///< d2x/dq_k2 (mixed derivatives vanish); zero but for rotations
    double offset = 0; ///< the tool's surface must stay this far from x: half thickness, or 0
    double area = 0; ///< tributary area: full circumference, or per unit width
    double compliance = 0; ///< through-thickness compliance: d(half thickness)/d(normal force) that no unknown
      ///< describes; solids: 0
    double recovery = 0; ///< elastic recovery of the face: how far it would rise if the transverse stress of the last
      ///< increment were taken off
    double reference_coordinate = 0; ///< R0, for output and messages
    double thickness = 0; ///< current, for output and messages
    double arc_coordinate = 0; ///< S0, arc length along the undeformed blank from its start, for output
  };
} // namespace deltaform
