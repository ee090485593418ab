#include "../outline_of_corners.h"

#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Any profile, given by corner points and fillets.
    class Profile : public OutlineOfCorners
    {
    public:
      explicit Profile(Section &section)
      {
        OutlineCorners corners;
        for (const std::vector<double> &row : section.rows("Points",
                                                           required(std::string("0 0; 1 0; 1 -1")),
                                                           2,
                                                           "length",
                                                           "Corner points r z, walked with the blank to the left: a "
                                                           "tool on the top inwards, one at the bottom outwards."))
          corners.points.emplace_back(row[0], row[1]);

        corners.radii = section.numbers(
          "Fillet radii", "", "length", "One radius per point, 0 for a sharp corner; empty for no fillets at all.");
        if (corners.radii.empty())
          corners.radii.assign(corners.points.size(), 0.);
        corners.closed = section.flag("Closed", false, "The last point is joined to the first.");
        read_ends(section);

        if (corners.points.size() < 2)
          section.fail("Points", "A profile needs at least two points.");
        if (corners.radii.size() != corners.points.size())
          section.fail("Fillet radii",
                       "There are " + std::to_string(corners.points.size()) + " points, but " +
                         std::to_string(corners.radii.size()) + " fillet radii.");
        try
        {
          set_corners(corners);
        }
        catch (const std::invalid_argument &error)
        {
          section.fail("Points", error.what());
        }
      }
    };

    const Registry<Shape>::Entry
      entry("profile", "Corner points with fillet radii, in the scene's frame", make_as<Profile, Shape>);
  } // namespace
} // namespace deltaform
