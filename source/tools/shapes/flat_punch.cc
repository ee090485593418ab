#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

namespace deltaform
{
  namespace
  {
    /// Flat face at z = 0, an edge radius and a wall that goes on for ever.
    class FlatPunch : public Shape
    {
    public:
      explicit FlatPunch(Section &section)
      {
        const double radius = section.number(
          "Radius", required(1.), Range::positive(), "length", "Radius of the wall (plane strain: half the width).");
        const double edge_radius = section.number("Edge radius",
                                                  Default<double>(.1),
                                                  Range::not_negative(),
                                                  "length",
                                                  "Radius between face and wall; 0 is a sharp edge.");
        if (edge_radius > radius)
          section.fail("Edge radius", "The edge radius is larger than the punch's radius.");
        build({Point2(0., 0.), Point2(radius, 0.), Point2(radius, -2 * radius)},
              {0., edge_radius, 0.},
              End::axis,
              End::endless);
      }
    };

    const Registry<Shape>::Entry
      entry("flat punch", "Flat face, edge radius and cylindrical wall", make_as<FlatPunch, Shape>);
  } // namespace
} // namespace deltaform
