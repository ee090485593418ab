#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

namespace deltaform
{
  namespace
  {
    /// Half a sphere (plane strain: half a cylinder) with its pole at the origin and a wall that goes on for ever.
    class HemisphericalPunch : public Shape
    {
    public:
      explicit HemisphericalPunch(Section &section)
      {
        const double radius = section.number(
          "Radius", required(1.), Range::positive(), "length", "Radius of the hemisphere and of the wall.");
        build(
          {Point2(0., 0.), Point2(radius, 0.), Point2(radius, -2 * radius)}, {0., radius, 0.}, End::axis, End::endless);
      }
    };

    const Registry<Shape>::Entry
      entry("hemispherical punch", "Hemisphere with a cylindrical wall", make_as<HemisphericalPunch, Shape>);
  } // namespace
} // namespace deltaform
