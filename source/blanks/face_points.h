#pragma once

#include "solid_edge.h"

#include <deltaform/assembly/point_origin.h>

#include <vector>

namespace deltaform
{
  /// The contact points of one side of a blank and where they lie on the undeformed body: what is compared when the
  /// mesh changes.
  struct FacePoints
  {
    std::vector<Point2> places; ///< of the nodes, in order
    std::vector<Edge> edges; ///< by the numbers of these
    std::vector<std::vector<double>> inside; ///< points of each edge, from 0 to 1 of it; empty: the nodes touch
  };

  /// Of every contact point of @p now, in order: where it lies among those of @p old, whose edges are still there,
  /// have been halved, or joined with the next one.
  std::vector<PointOrigin> point_origins(const FacePoints &old, const FacePoints &now);
} // namespace deltaform
