// Radius of the circle through a part of the section.
#include "section_points.h"

#include <deltaform/measures/measure.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    class Arc : public Measure
    {
    public:
      explicit Arc(Section &section)
        : Measure(section.title()),
          from_(section.number("From", required(10.), Range::not_negative(), "length",
                               "Initial arc length from the start of the blank at which the part begins.")),
          to_(section.number("To", required(20.), Range::not_negative(), "length",
                             "Initial arc length at which it ends."))
      {
        if (!(to_ > from_))
          section.fail("To", "must be larger than From");
      }

      std::vector<Result> of(const Table &now, const Table & /*before*/) const override
      {
        const auto circle = fit_circle(points_between(now, from_, to_));
        return circle ? std::vector<Result>{{"radius", circle->radius}} : std::vector<Result>();
      }

      std::string needs() const override
      {
        return "between From and To it needs three nodes of the blank that are not on a line";
      }

    private:
      double from_, to_;
    };

    const MeasureRegistry::Entry entry("arc", "radius of the circle through a part of the section",
                                       make_as<Arc, Measure>);
  } // namespace
} // namespace deltaform
