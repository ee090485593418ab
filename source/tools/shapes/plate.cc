#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// A flat face at z = 0 from one radius to another, with walls at its edges. From radius 0 it goes on across the
    /// axis.
    class Plate : public Shape
    {
    public:
      explicit Plate(Section &section)
      {
        const double inner = section.number("Inner radius",
                                            Default<double>(0.),
                                            Range::any(),
                                            "length",
                                            "Coordinate r (plane strain: x, may be negative) where the plate starts; "
                                            "at 0 it has no edge and goes on across the axis.");
        const double outer = section.number("Outer radius",
                                            Default<double>(endless_radius),
                                            Range::any(),
                                            "length",
                                            "Coordinate r where the plate ends; with the default it goes on for ever.");
        const double edge_radius = section.number("Edge radius",
                                                  Default<double>(0.),
                                                  Range::not_negative(),
                                                  "length",
                                                  "Radius between the face and the walls; 0 is a sharp edge.");
        const bool from_axis = inner == 0., endless = outer >= endless_radius;
        if (outer <= inner)
          section.fail("Outer radius", "The outer radius must be larger than the inner radius.");
        if (!endless && edge_radius * (from_axis ? 1 : 2) > outer - inner)
          section.fail("Edge radius", "The edge radius does not fit on the plate.");

        const double size = endless ? std::max({1., 2 * std::abs(inner), 2 * edge_radius}) : outer - inner;
        const double depth = edge_radius + .25 * size;
        std::vector<Point2> points;
        std::vector<double> radii;
        const auto add = [&](const double r, const double z, const double radius) {
          points.emplace_back(r, z);
          radii.push_back(radius);
        };
        if (!from_axis)
          add(inner, -depth, 0.);
        add(inner, 0., edge_radius);
        add(inner + size, 0., edge_radius);
        if (!endless)
        {
          points.back()[0] = outer;
          add(outer, -depth, 0.);
        }
        build(points, radii, from_axis ? End::axis : End::endless, End::endless);
      }
    };

    const Registry<Shape>::Entry
      entry("plate", "Flat face, whole or a ring, with or without rounded edges", make_as<Plate, Shape>);
  } // namespace
} // namespace deltaform
