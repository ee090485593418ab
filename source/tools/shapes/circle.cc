#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

namespace deltaform
{
  namespace
  {
    /// A whole circle about the origin. Arc length starts where the blank is not: below a cylinder, above in a bore.
    class Circle : public Shape
    {
    public:
      explicit Circle(Section &section)
      {
        const double r = section.number(
          "Radius", required(1.), Range::positive(), "length", "Radius of the circle about the position.");
        const bool concave = section.flag("Concave", false, "The tool is outside, the blank inside the circle.");
        // The square around the circle, clockwise if the blank is outside; its corners are rounded to nothing but arcs.
        if (concave)
          build_closed({Point2(-r, r), Point2(-r, -r), Point2(r, -r), Point2(r, r)}, {r, r, r, r});
        else
          build_closed({Point2(-r, -r), Point2(-r, r), Point2(r, r), Point2(r, -r)}, {r, r, r, r});
      }
    };

    const Registry<Shape>::Entry entry("circle", "Whole circle, the blank outside or inside", make_as<Circle, Shape>);
  } // namespace
} // namespace deltaform
