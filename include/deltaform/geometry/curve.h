#pragma once

#include <deltaform/geometry/segment.h>

#include <utility>
#include <vector>

namespace deltaform
{
  class FilletedCorners;

  /// The closest point of a curve to a given point.
  struct Projection
  {
    double distance; ///< signed: positive on the left of the curve, the blank's side; negative inside the tool
    Tensor1 normal; ///< unit, gradient of the distance: points out of the tool, to the blank
    Tensor1 tangent; ///< unit, along growing arc length
    double curvature; ///< of the parallel curve through the given point: k/(1 + k distance), k that of the curve,
      ///< convex positive; d(angle of the normal)/d(displacement along the tangent)
    double slip_rate; ///< d(arc length of the closest point)/d(displacement along the tangent) = 1/(1 + k distance); 0
      ///< at a corner
    double arc_length; ///< of the closest point along the curve
    unsigned int segment; ///< warm start of the next projection
  };

  /**
   * Lines and arcs, traversed so that the blank lies to the left, that is, the outward normal is the tangent turned by
   * +90 degrees. The closest point and its normal are exact. Corners without fillet turn the normal about the corner
   * point.
   */
  class Curve
  {
  public:
    /// What is at an end.
    enum class End
    {
      free, ///< nothing: past it there is no contact
      endless, ///< the line goes on for ever
      axis ///< it lies on r = 0 and goes on as its mirror image, so that a node on the axis is an ordinary node
    };

    Curve() = default;

    /**
     * From corner points with fillet radii, one per point; first and last are ignored; 0 is a sharp corner.
     * @throws std::invalid_argument as FilletedCorners does, or if an end is not as it is said to be
     */
    Curve(const std::vector<Point2> &points,
          const std::vector<double> &radii,
          End start = End::free,
          End end = End::free);

    /// The same for a closed curve: the last point is joined to the first, and all radii count.
    static Curve closed(const std::vector<Point2> &points, const std::vector<double> &radii);

    /**
     * Closest point among all segments; the result does not depend on @p hint, the segment of the last projection of
     * the same node (invalid_index: none), but for points that have two closest points.
     * @return distance = +infinity if the closest point is a free end.
     */
    Projection project(const Point2 &x, unsigned int hint = invalid_index) const;

    const std::vector<Segment> &segments() const
    {
      return segments_;
    }

    /// Total arc length (endless lines as given).
    double length() const;

    /// The arc length from closest point @p a to closest point @p b, the short way round if the curve is closed.
    double slip(double a, double b) const;

    /// Call @p action with a place on the curve and with its images: a turn further if closed, mirrored at the axis.
    template <typename Action>
    void for_each_image(const double arc_length, const Action &action) const
    {
      action(arc_length);
      if (closed_)
      {
        action(arc_length + length());
        action(arc_length - length());
      }
      if (start_ == End::axis)
        action(-arc_length);
      if (end_ == End::axis)
        action(2 * length() - arc_length);
    }

    /**
     * Points along the curve for output.
     * @param angle arcs are divided into chords of at most this angle (radians).
     * @param reach endless lines are at least this long.
     * @param both_sides with the mirror image, if an end is on the axis.
     */
    std::vector<Point2> polyline(double angle = .02, double reach = 0., bool both_sides = false) const;

    /// Smallest box that holds the curve and its mirror image: lower left, upper right; infinite along endless lines.
    std::pair<Point2, Point2> bounding_box() const;

  private:
    void add_segments(const std::vector<Point2> &points,
                      const std::vector<double> &radii,
                      const FilletedCorners &corners);

    /// What is at the end @p point of the first (@p sign -1) or last (1) segment.
    void end_with(End what, Segment &segment, const Point2 &point, double sign);

    Projection project_one_side(const Point2 &x, unsigned int hint) const;

    std::vector<Segment> segments_;
    std::vector<Point2> free_ends_;
    bool closed_ = false;
    End start_ = End::free, end_ = End::free;
  };
} // namespace deltaform
