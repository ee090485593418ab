#pragma once

#include <deltaform/base/types.h>

namespace deltaform
{
  /**
   * What contact sees of a blank at one node of one side: a point that moves with at most three unknowns. Whether a
   * shell or a solid stands behind it does not show.
   */
  struct ContactNode
  {
    static constexpr unsigned int max_dofs = 3;

    unsigned int node   = invalid_index; ///< number of the node within the blank
    unsigned int n_dofs = 0;
    std::array<DofIndex, max_dofs> dofs{};
    Point2 x;                                 ///< current position of the contact point
    std::array<Tensor1, max_dofs> jacobian{}; ///< dx/dq_k
    std::array<Tensor1, max_dofs> second{};   ///< d2x/dq_k2 (mixed derivatives vanish); zero but for rotations
    double offset               = 0;          ///< the tool surface must stay this far from x: half thickness, or 0
    double area                 = 0;          ///< tributary area, full circumference or per unit width
    double reference_coordinate = 0;          ///< R0, for output
    double thickness            = 0;          ///< for messages and relative delta
  };
} // namespace deltaform
