#pragma once

#include <deltaform/blanks/boundary.h>

#include <vector>

namespace deltaform
{
  /// Lengths that a draw bead is described by.
  struct BeadLengths
  {
    double place; ///< r in the scene, which the sheet passes
    double length; ///< of sheet that must pass until the bead holds fully, and that lies in it
    double elastic_slip; ///< until it holds fully where the sheet turns back
  };


  /// What a draw bead remembers of the sheet that passes it.
  struct BeadHistory
  {
    double material = 0; ///< arc length in the undeformed blank of what is at the bead
    double share = 0; ///< of the restraining force that acts, positive along growing arc length
    double path = 0; ///< length of undeformed sheet that has passed, to and fro
  };


  /**
   * A line of nodes that passes a draw bead. s is the arc length in the undeformed blank of the material that is at
   * the place, between two nodes by their distances along r. The share m of the restraining force that the bead has
   * mobilised is a return map of the passed length s - s_n, by the elastic slip e, to the limit
   *
   *   |m| <= min(path/L, 1) min(rest/L, 1),      trial m_n + (s - s_n)/e,
   *
   * with the path passed so far and the rest of sheet that has not yet entered: the force grows while the first bead
   * length L passes, and falls when the last one does. m acts along r on both nodes in inverse ratio of their
   * distances, so that it works on the material at the place.
   */
  class BeadLine
  {
  public:
    BeadLine(const BeadLengths &lengths, std::vector<LineNode> nodes)
      : lengths_(lengths), nodes_(std::move(nodes))
    {
    }

    void renumber(std::vector<LineNode> nodes)
    {
      nodes_ = std::move(nodes);
    }

    /// Is there sheet at the bead, in the state @p q?
    bool passes(const Vector &q) const;

    /// The bead closes on the sheet in the state @p q.
    void begin(const Vector &q);

    /// Add the forces of a bead of the restraining force @p force (all round, or per unit width).
    void add(const Vector &q, double force, AssemblyTarget &target) const;

    /// Of the state @p q, to be accepted. @return share of the force and length that has passed
    BeadHistory next(const Vector &q) const;

    BeadHistory history;

  private:
    /// Sheet at the bead: the node before and after it, and where between them.
    struct Crossing
    {
      unsigned int node = invalid_index; ///< and the next; invalid_index: no sheet
      double share = 0, span = 0, arc = 0; ///< of the next node; distance of both along r (signed) and in arc length
      double material = 0;
    };

    /// A share and its derivative by the material at the bead.
    struct Mobilized
    {
      double share, slope;
    };

    double r(const Vector &q, unsigned int node) const
    {
      return nodes_[node].r + q[nodes_[node].unknown];
    }

    /// The one nearest to the material that was at the bead before.
    Crossing find(const Vector &q) const;
    Mobilized mobilize(double material) const;

    BeadLengths lengths_;
    std::vector<LineNode> nodes_;
  };
} // namespace deltaform
