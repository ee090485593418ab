// Angle by which the section turns between two straight legs.
#include "section_points.h"

#include <deltaform/measures/measure.h>
#include <deltaform/parameters/section.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    class Angle : public Measure
    {
    public:
      explicit Angle(Section &section)
        : Measure(section.title()), first_(read_leg(section, "First leg", "0 10")),
          second_(read_leg(section, "Second leg", "30 40"))
      {
      }

      std::vector<Result> of(const Table &now, const Table & /*before*/) const override
      {
        const auto a = points_between(now, first_[0], first_[1]), b = points_between(now, second_[0], second_[1]);
        if (a.size() < 2 || b.size() < 2)
          return {};
        const double turn = turn_in_degrees(direction(b.front(), b.back()) - direction(a.front(), a.back()));
        return {{"bend_angle", turn}, {"included_angle", 180. - std::abs(turn)}};
      }

      std::string needs() const override
      {
        return "each of First leg and Second leg needs two nodes of the blank between its ends";
      }

    private:
      static std::vector<double> read_leg(Section &section, const std::string &entry, const std::string &example)
      {
        const auto rows = section.rows(entry, required(example), 2, "length",
                                       "From where to where the leg goes, initial arc lengths from the start of the "
                                       "blank; its direction is that of the chord.");
        if (rows.size() != 1 || !(rows[0][1] > rows[0][0]))
          section.fail(entry, "a leg has a beginning and a later end");
        return rows[0];
      }

      std::vector<double> first_, second_;
    };

    const MeasureRegistry::Entry entry("angle", "by which the section turns between two legs",
                                       make_as<Angle, Measure>);
  } // namespace
} // namespace deltaform
