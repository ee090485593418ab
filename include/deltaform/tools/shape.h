#pragma once

#include <deltaform/base/types.h>

#include <vector>

namespace deltaform
{
  /// The closest point of a profile to a given point.
  struct Projection
  {
    double distance; ///< signed: positive on the blank's side, negative inside the tool
    Tensor1 normal;  ///< unit, gradient of the distance: points out of the tool, to the blank
    Tensor1 tangent; ///< unit, along growing arc length
    double turning; ///< d(angle of the normal)/d(displacement along the tangent) = k/(1 + k distance), k the curvature,
                    ///< convex positive
    double slip_rate;  ///< d(arc length of the foot point)/d(displacement along the tangent) = 1/(1 + k distance); 0 at
                       ///< a corner
    double arc_length; ///< of the foot point along the profile
    unsigned int segment; ///< warm start of the next projection
  };

  /// A straight line or a circular arc of a profile; a corner is an arc of radius zero.
  struct Segment
  {
    enum class Kind : unsigned char
    {
      line,
      arc
    };

    Kind kind = Kind::line;
    Point2 start, end;         ///< ends (equal for a corner)
    double length    = 0;      ///< arc length
    double arc_start = 0;      ///< arc length of the profile at the start
    Tensor1 tangent;           ///< line: direction
    Point2 center;             ///< arc
    double radius      = 0;    ///< arc: >= 0
    bool convex        = true; ///< arc: center on the tool's side
    double angle_start = 0;    ///< arc: polar angle of (start - center), or of the normal for a corner
    double sweep       = 0;    ///< arc: signed angle from start to end
  };

  /**
   * The profile of a rigid tool in its own frame: lines and arcs, traversed so that the blank lies to the left, that
   * is, the outward normal is the tangent turned by +90 degrees. The closest point and its normal are exact. Corners
   * without fillet that are convex turn the normal about the corner point; past the free ends of the profile there is
   * no contact.
   */
  class Shape
  {
  public:
    virtual ~Shape() = default;

    /// Closest point among all segments; @p hint is the segment of the last projection of the same node (invalid_index:
    /// none).
    /// @return distance = +infinity if the closest point is a free end of the profile.
    Projection project(const Point2 &x, unsigned int hint = invalid_index) const;

    const std::vector<Segment> &segments() const
    {
      return segments_;
    }

    /// Points along the profile for output, arcs divided into chords of at most @p angle radians.
    std::vector<Point2> polyline(double angle = .02) const;

    /// Smallest box that holds the profile: lower left, upper right.
    std::pair<Point2, Point2> bounding_box() const;

    /// Smallest radius of the profile's arcs that is not zero (infinity without arcs).
    double smallest_radius() const;

  protected:
    /**
     * Build the segments from corner points with fillet radii (radii.size() == points.size(); first and last are
     * ignored; 0 is a sharp corner). @throws std::invalid_argument if a fillet does not fit.
     */
    void build(const std::vector<Point2> &points, const std::vector<double> &radii, bool closed = false);

    std::vector<Segment> segments_;
  };
} // namespace deltaform
