#include <deltaform/base/registry.h>
#include <deltaform/tools/shape.h>

#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Any profile, given by corner points in the scene's frame (moved by the tool's position, but never mirrored).
    class Profile : public Shape
    {
    public:
      explicit Profile(Section &section)
      {
        std::vector<Point2> points;
        for (const std::vector<double> &row : section.rows("Points",
                                                           required(std::string("0 0; 1 0; 1 -1")),
                                                           2,
                                                           "length",
                                                           "Corner points r z, walked with the blank to the left."))
          points.emplace_back(row[0], row[1]);

        std::vector<double> radii = section.numbers(
          "Fillet radii", "", "length", "One radius per point, 0 for a sharp corner; empty for no fillets at all.");
        if (radii.empty())
          radii.assign(points.size(), 0.);
        const bool closed = section.flag("Closed", false, "The last point is joined to the first.");
        const bool across =
          section.flag("Across the axis", true, "An end on r = 0 is no edge: the profile goes on as its mirror image.");

        if (points.size() < 2)
          section.fail("Points", "A profile needs at least two points.");
        if (radii.size() != points.size())
          section.fail("Fillet radii",
                       "There are " + std::to_string(points.size()) + " points, but " + std::to_string(radii.size()) +
                         " fillet radii.");
        const auto end = [&](const Point2 &point) { return across && point[0] == 0. ? End::axis : End::free; };
        try
        {
          if (closed)
            build_closed(points, radii);
          else
            build(points, radii, end(points.front()), end(points.back()));
        }
        catch (const std::invalid_argument &error)
        {
          section.fail("Points", error.what());
        }
      }

      bool in_scene_frame() const override
      {
        return true;
      }
    };

    const Registry<Shape>::Entry
      entry("profile", "Corner points with fillet radii, in the scene's frame", make_as<Profile, Shape>);
  } // namespace
} // namespace deltaform
