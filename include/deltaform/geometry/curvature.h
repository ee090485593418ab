#pragma once

namespace deltaform
{
  class Curve;

  /// At a place that is no joint of segments; of a corner 0. Convex positive (1/length), as all below.
  double curvature(const Curve &curve, double arc_length);

  /// Mean curvature between the places @p reach before and after @p arc_length: without the jumps of the curvature
  /// where lines and arcs join. Corners count as straight.
  double mean_curvature(const Curve &curve, double arc_length, double reach);

  /// d(mean curvature)/d(arc length).
  double curvature_change(const Curve &curve, double arc_length, double reach);

  /// Share of a friction force near sharp corners.
  struct CornerShare
  {
    double value = 1;
    double slope = 0; ///< by arc length (1/length)
  };

  /**
   * How much of a friction force reaches a node that is kept off the curve by @p offset. At a sharp corner, around which
   * the node turns without slip, there is none; it grows to all of it within a quarter of the way around the corner,
   * the angle times the offset. A force that jumped there would leave a node that comes to rest at the corner without
   * equilibrium (doc/theory/contact.md).
   */
  CornerShare corner_share(const Curve &curve, double arc_length, double offset);

  /**
   * The slip of a node that is kept off the curve by @p offset while its closest point goes from @p a to @p b: the
   * integral of c (1 + k offset)/(1 + mean k offset) over the arc length, c = corner_share(), so that a friction force
   * that reaches the node by the share c/(1 + mean k offset) does the same work on both sides (doc/theory/contact.md).
   * On lines, and on arcs, away from their ends the arc length itself.
   */
  double offset_slip(const Curve &curve, double a, double b, double offset);

  /// Smallest radius of the arcs that is not zero (infinity without arcs).
  double smallest_radius(const Curve &curve);

  /// Smallest radius of the arcs between two places, the short way round if the curve is closed; 0 if there is a
  /// sharp corner that points to the blank; infinity if all is straight.
  double smallest_radius(const Curve &curve, double from, double to);
} // namespace deltaform
