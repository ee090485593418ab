#pragma once

#include <deltaform/assembly/side.h>
#include <deltaform/parameters/skipped_time.h>
#include <deltaform/parameters/time_function.h>
#include <deltaform/tools/shape.h>

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * A rigid tool: a shape at a position, mirrored if it touches the top of the blank, that travels along a direction.
   * The travel is a function of time; or a force is, and the travel is an unknown of the step.
   */
  class Tool
  {
  public:
    /**
     * Read the tool from its section.
     * @param name of the section, by which results and messages call the tool
     * @param constants what the expressions of the section may use beside t: "thickness"
     * @param penetration_constants the same for the allowed penetration: also "edge", the shortest contact edge
     * @param axisymmetric is the blank a body of revolution? If not, r = 0 is no axis (Shape::set_plane_strain())
     */
    Tool(const std::string &name,
         Section section,
         const std::map<std::string, double> &constants,
         const std::map<std::string, double> &penetration_constants,
         bool axisymmetric = true);

    const std::string &name() const
    {
      return name_;
    }

    /// The face of the blank that the tool touches.
    Side side() const
    {
      return side_;
    }

    /// In the tool's own frame.
    const Shape &shape() const
    {
      return *shape_;
    }

    /// Where the origin of the shape is at travel 0.
    const Point2 &position() const
    {
      return position_;
    }

    /// Unit vector of the travel in the scene.
    const Tensor1 &direction() const
    {
      return direction_;
    }

    bool force_driven() const
    {
      return force_.has_value();
    }

    /// Travel along the direction by the motion at @p time; of a force-driven tool 0, where it begins: where it goes is
    /// an unknown.
    double travel(const double time) const
    {
      return force_driven() ? 0. : skipped_.value(motion_, time);
    }

    /// First time in [begin, end] at which the motion reaches a travel; NaN if it does not.
    double time_of_travel(const double travel, const double begin, const double end) const
    {
      return motion_.inverse(travel, begin, end);
    }

    /// Force along the direction, pressed against the blank, of a force-driven tool.
    double force(double time) const;

    /// What the run has skipped: motion and force go on from where they were.
    void skip(const SkippedTime &skipped)
    {
      skipped_ = skipped;
    }

    /// @name Where a force-driven tool is stopped
    ///@{
    /// Largest travel; infinite where the tool has no such stop.
    double stop_travel(const double time) const
    {
      return stop_travel_ ? (*stop_travel_)(time) : std::numeric_limits<double>::infinity();
    }

    /// Least gap to the tools on the other side of the blank (length).
    double stop_gap() const
    {
      return stop_gap_;
    }
    ///@}

    /// Smallest and largest travel between two times, sampled at equal distances including both ends.
    std::pair<double, double> travel_range(double begin, double end) const;

    /// The tool's own allowed penetration (length over time; see ContactSettings for 'auto'), or null.
    const TimeFunction *allowed_penetration() const;

    /// Does the tool take part in this stage?
    bool exists_in(const std::string &stage) const;

    /// Stages in which the tool takes part; none stands for all.
    const std::vector<std::string> &stages() const
    {
      return stages_;
    }

    /**
     * Closest point to @p x, both in the scene's frame. The normal is the gradient of the distance, the tangent points
     * to growing arc length, d(normal)/dx = curvature tangent (x) tangent. The normal is the tangent turned by +90
     * degrees, or by -90 degrees where the shape is mirrored.
     */
    Projection project(const Point2 &x, double travel, unsigned int hint = invalid_index) const;

    /// The profile for output, see Shape::polyline().
    std::vector<Point2> polyline(double travel, double reach = 0., bool both_sides = false) const;

    /// Smallest box that holds the tool: lower left, upper right; may be infinite.
    std::pair<Point2, Point2> bounding_box(double travel) const;

  private:
    Point2 to_scene(const Point2 &own, double travel) const;

    std::string name_;
    Side side_;
    std::unique_ptr<Shape> shape_;
    Point2 position_;
    Tensor1 direction_;
    double mirror_ = 1; ///< of z from the tool's own frame to the scene's: 1 or -1
    TimeFunction motion_;
    std::optional<TimeFunction> force_;
    std::optional<TimeFunction> stop_travel_;
    double stop_gap_ = 0;
    SkippedTime skipped_;
    std::optional<TimeFunction> allowed_penetration_;
    std::vector<std::string> stages_;
  };
} // namespace deltaform
