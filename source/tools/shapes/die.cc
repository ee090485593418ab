#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

namespace deltaform
{
  namespace
  {
    /// An opening whose wall comes from below, the profile radius, and a flat shoulder at z = 0.
    class Die : public Shape
    {
    public:
      explicit Die(Section &section)
      {
        const double throat = section.number("Throat radius",
                                             required(1.),
                                             Range::positive(),
                                             "length",
                                             "Radius of the opening (plane strain: half its width).");
        const double profile_radius = section.number("Profile radius",
                                                     required(.2),
                                                     Range::not_negative(),
                                                     "length",
                                                     "Radius between the wall and the shoulder; 0 is a sharp edge.");
        const double outer =
          section.number("Outer radius",
                         Default<double>(endless_radius),
                         Range::positive(),
                         "length",
                         "Where the shoulder ends with a wall; with the default it goes on for ever.");
        if (outer <= throat + profile_radius)
          section.fail("Outer radius", "The outer radius must be larger than throat radius plus profile radius.");

        const double depth = 2 * (throat + profile_radius);
        std::vector<Point2> points{Point2(throat, -depth), Point2(throat, 0.)};
        std::vector<double> radii{0., profile_radius};
        if (outer < endless_radius)
        {
          points.insert(points.end(), {Point2(outer, 0.), Point2(outer, -depth)});
          radii.insert(radii.end(), {0., 0.});
        }
        else
        {
          points.emplace_back(throat + profile_radius + depth, 0.);
          radii.push_back(0.);
        }
        build(points, radii, End::endless, End::endless);
        throat_ = throat;
      }

      double opening() const override
      {
        return throat_;
      }

    private:
      double throat_ = 0.;
    };

    const Registry<Shape>::Entry entry("die", "Opening, profile radius and flat shoulder", make_as<Die, Shape>);
  } // namespace
} // namespace deltaform
