#include <deltaform/parameters/registry.h>
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
        for (const std::vector<double> &row : section.rows("Points",
                                                           required(std::string("0 0; 1 0; 1 -1")),
                                                           2,
                                                           "length",
                                                           "Corner points r z, walked with the blank to the left."))
          points_.emplace_back(row[0], row[1]);

        radii_ = section.numbers(
          "Fillet radii", "", "length", "One radius per point, 0 for a sharp corner; empty for no fillets at all.");
        if (radii_.empty())
          radii_.assign(points_.size(), 0.);
        is_closed_ = section.flag("Closed", false, "The last point is joined to the first.");
        across_ = section.choice("Across the axis",
                                 "auto",
                                 {"auto", "true", "false"},
                                 "Is an end on r = 0 no edge, so that the profile goes on as its mirror image? auto: "
                                 "yes if the blank is axisymmetric, no in plane strain.");

        if (points_.size() < 2)
          section.fail("Points", "A profile needs at least two points.");
        if (radii_.size() != points_.size())
          section.fail("Fillet radii",
                       "There are " + std::to_string(points_.size()) + " points, but " + std::to_string(radii_.size()) +
                         " fillet radii.");
        try
        {
          build_ends(across_ != "false");
        }
        catch (const std::invalid_argument &error)
        {
          section.fail("Points", error.what());
        }
      }

      void set_plane_strain() override
      {
        if (across_ == "auto")
          build_ends(false);
      }

      bool in_scene_frame() const override
      {
        return true;
      }

    private:
      void build_ends(const bool across)
      {
        const auto end = [&](const Point2 &point) { return across && point[0] == 0. ? End::axis : End::free; };
        if (is_closed_)
          build_closed(points_, radii_);
        else
          build(points_, radii_, end(points_.front()), end(points_.back()));
      }

      std::vector<Point2> points_;
      std::vector<double> radii_;
      bool is_closed_;
      std::string across_;
    };

    const Registry<Shape>::Entry
      entry("profile", "Corner points with fillet radii, in the scene's frame", make_as<Profile, Shape>);
  } // namespace
} // namespace deltaform
