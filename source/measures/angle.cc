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
        : Measure(section.title()),
          first_(read_leg(section, "First leg", "",
                          " Empty: the direction of r, where half of a part is modelled that is alike on the other "
                          "side of r = 0; half of its angles is measured.")),
          second_(read_leg(section, "Second leg", required("30 40"), ""))
      {
      }

      std::vector<Result> of(const Table &now, const Table & /*before*/) const override
      {
        const std::vector<Point2> along_r{Point2(0., 0.), Point2(1., 0.)};
        const auto a = first_.empty() ? along_r : points_between(now, first_[0], first_[1]);
        const auto b = points_between(now, second_[0], second_[1]);
        if (a.empty() || b.empty())
          return {};
        const double turn = turn_in_degrees(direction(b.front(), b.back()) - direction(a.front(), a.back()));
        return {{"bend_angle", turn}, {"included_angle", 180. - std::abs(turn)}};
      }

      std::string needs() const override
      {
        return "each of First leg and Second leg has to begin on the blank";
      }

    private:
      static std::vector<double> read_leg(Section &section, const std::string &entry,
                                          const Default<std::string> &value, const std::string &more)
      {
        const auto rows = section.rows(entry, value, 2, "length",
                                       "From where to where the leg goes, initial arc lengths from the start of the "
                                       "blank; its direction is that of the chord." +
                                         more);
        if (rows.empty())
          return {};
        if (rows.size() != 1 || !(rows[0][1] > rows[0][0]))
          section.fail(entry, "a leg has a beginning and a later end");
        return rows[0];
      }

      std::vector<double> first_, second_; ///< where a leg begins and ends (length)
    };

    const MeasureRegistry::Entry entry("angle", "by which the section turns between two legs",
                                       make_as<Angle, Measure>);
  } // namespace
} // namespace deltaform
