#pragma once

#include <deltaform/base/types.h>

#include <utility>
#include <vector>

namespace deltaform
{
  /// The closest point of a profile to a given point.
  struct Projection
  {
    double distance; ///< signed: positive on the blank's side, negative inside the tool
    Tensor1 normal; ///< unit, gradient of the distance: points out of the tool, to the blank
    Tensor1 tangent; ///< unit, along growing arc length
    double turning; ///< d(angle of the normal)/d(displacement along the tangent) = k/(1 + k distance), k the curvature,
      ///< convex positive: d(normal)/dx = turning tangent (x) tangent
    double slip_rate; ///< d(arc length of the foot point)/d(displacement along the tangent) = 1/(1 + k distance); 0 at
      ///< a corner
    double arc_length; ///< of the foot point along the profile
    unsigned int segment; ///< warm start of the next projection
  };

  /**
   * The profile of a rigid tool in its own frame: lines and arcs, traversed so that the blank lies to the left, that
   * is, the outward normal is the tangent turned by +90 degrees. The closest point and its normal are exact. Corners
   * without fillet turn the normal about the corner point.
   */
  class Shape
  {
  public:
    /// A straight line or a circular arc of a profile; a corner is an arc of radius zero.
    struct Segment
    {
      enum class Kind : unsigned char
      {
        line,
        arc
      };

      Kind kind = Kind::line;
      bool convex = true; ///< arc: center on the tool's side
      Point2 start, end; ///< ends (equal for a corner)
      Point2 lower, upper; ///< smallest box that holds the segment
      double length = 0; ///< arc length (of an endless line: as drawn)
      double arc_start = 0; ///< arc length of the profile at the start
      Tensor1 tangent; ///< line: direction
      double first = 0,
             last = 0; ///< line: foot points have a distance from the start, along the tangent, in [first, last]
      Point2 center; ///< arc
      double radius = 0; ///< arc: >= 0
      Tensor1 from, to; ///< arc: unit vectors from the center to start and end (of a corner: +- the normals)
      double angle_start = 0; ///< arc: polar angle of `from`
      double sweep = 0; ///< arc: signed angle from start to end, negative if convex, |sweep| < pi
    };

    /// What is at an end of the profile.
    enum class End
    {
      free, ///< nothing: past it there is no contact
      endless, ///< the line goes on for ever
      axis ///< it lies on r = 0 and goes on as its mirror image, so that a node on the axis is an ordinary node
    };

    virtual ~Shape() = default;

    /**
     * Closest point among all segments; the result does not depend on @p hint, the segment of the last projection of
     * the same node (invalid_index: none), but for points that have two closest points.
     * @return distance = +infinity if the closest point is a free end of the profile.
     */
    Projection project(const Point2 &x, unsigned int hint = invalid_index) const;

    const std::vector<Segment> &segments() const
    {
      return segments_;
    }

    /// Are the points of the profile given in the scene's frame (no mirror image if the tool touches the blank's top)?
    virtual bool in_scene_frame() const
    {
      return false;
    }

    /// The blank is one of plane strain, in which r = 0 is a line like any other and no axis. Called once, before the
    /// first projection. A shape that the user gives point by point leaves out the mirror image then, unless it is
    /// asked for.
    virtual void set_plane_strain()
    {
    }

    /// The arc length from foot point @p a to foot point @p b, the short way round if the profile is closed.
    double slip(double a, double b) const;

    /**
     * The slip of a node that is kept off the profile by @p offset while its foot goes from @p a to @p b: the integral
     * of (1 + k offset)/(1 + mean k offset) over the arc length, so that a friction force that reaches the node by the
     * share 1/(1 + mean k offset) does the same work on both sides (doc/theory/contact.md). On lines, and on arcs away
     * from their ends, the arc length itself.
     */
    double slip(double a, double b, double offset) const;

    /// At a place that is no joint; of a corner 0.
    double curvature(double arc_length) const;

    /// Mean curvature (convex positive, 1/length) between the places @p reach before and behind @p arc_length: without
    /// the jumps of the curvature where lines and arcs join. Corners count as straight.
    double mean_curvature(double arc_length, double reach) const;

    /// d(mean curvature)/d(arc length).
    double curvature_change(double arc_length, double reach) const;

    /// Length of the profile (endless lines as drawn).
    double length() const;

    /**
     * Points along the profile for output.
     * @param angle arcs are divided into chords of at most this angle (radians).
     * @param reach endless lines are drawn at least this long.
     * @param both_sides draw also the mirror image of a profile that has an end on the axis.
     */
    std::vector<Point2> polyline(double angle = .02, double reach = 0., bool both_sides = false) const;

    /// Smallest box that holds the profile and its mirror image: lower left, upper right; infinite along endless lines.
    std::pair<Point2, Point2> bounding_box() const;

    /// Radius of the hole through which a blank that ends inside it would fall; 0: none.
    virtual double opening() const
    {
      return 0.;
    }

    /// Smallest radius of the profile's arcs that is not zero (infinity without arcs).
    double smallest_radius() const;

    /// Smallest radius of the arcs between two foot points, the short way round if the profile is closed; 0 if there is
    /// a sharp corner that points to the blank; infinity if all is straight.
    double smallest_radius(double from, double to) const;

  protected:
    /// Where an entry of a shape has this value, its line goes on for ever.
    static constexpr double endless_radius = 1e30;

    /**
     * Build the segments from corner points with fillet radii (radii.size() == points.size(); first and last are
     * ignored; 0 is a sharp corner). @throws std::invalid_argument, naming the corner, if a fillet does not fit, or if
     * two neighbouring points coincide.
     */
    void build(const std::vector<Point2> &points,
               const std::vector<double> &radii,
               End start = End::free,
               End end = End::free);

    /// The same for a closed profile: the last point is joined to the first, and all radii count.
    void build_closed(const std::vector<Point2> &points, const std::vector<double> &radii);

  private:
    void assemble(const std::vector<Point2> &points, const std::vector<double> &radii);
    void add_line(const Point2 &start, const Point2 &end, const Tensor1 &tangent);
    void add_arc(const Point2 &start,
                 const Point2 &end,
                 const Tensor1 &tangent_before,
                 const Tensor1 &tangent_after,
                 double radius);

    /// Call @p action with a place on the profile and with those of its images: once around, mirrored at the axis.
    template <typename Action>
    void for_each_image(double arc_length, const Action &action) const;

    Projection project_one_side(const Point2 &x, unsigned int hint) const;

    std::vector<Segment> segments_;
    std::vector<Point2> free_ends_;
    bool closed_ = false;
    End start_ = End::free, end_ = End::free;
  };
} // namespace deltaform
