// Angles and side-wall curl of a U-bend, as the NUMISHEET'93 benchmark has them.
#include "section_points.h"

#include <deltaform/measures/measure.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    /**
     * theta1 is the angle between bottom and wall, theta2 the one between wall and flange (90 degrees without
     * springback), rho the radius of the circle through the wall: A. Makinouchi, E. Nakamachi, E. Onate, R. H. Wagoner
     * (eds.), Proc. NUMISHEET'93, Isehara 1993. The wall is what was more than a margin away from bottom and flange in
     * height before the release; its directions are the tangents of the circle at its ends.
     */
    class UBend : public Measure
    {
    public:
      explicit UBend(Section &section)
        : Measure(section.title()),
          margin_(section.number("Margin", 15., Range::positive(), "length",
                                 "The wall is what was more than this above the bottom and below the flange before the "
                                 "last stage.")),
          leg_(section.number("Leg", 10., Range::positive(), "length",
                              "Length of the legs at both ends of the blank whose chords are the directions of bottom "
                              "and flange."))
      {
      }

      std::vector<Result> of(const Table &now, const Table &before) const override
      {
        const auto s = column_of(now, "S0"), height = column_of(before, "z");
        const auto all = points_of(now);
        if (height.size() != all.size() || all.size() < 2)
          return {};
        const auto [begin, end] = wall_of(s, height);
        const auto wall = points_between(now, begin, end);
        const auto bottom = points_between(now, s.front(), s.front() + leg_);
        const auto flange = points_between(now, s.back() - leg_, s.back());
        const auto circle = wall.size() < 7 ? std::nullopt : fit_circle(wall);
        if (!circle || bottom.size() < 2 || flange.size() < 2)
          return {};
        const double chord = direction(wall.front(), wall.back());
        const double flat = direction(bottom.front(), bottom.back()), rim = direction(flange.front(), flange.back());
        const double lower = circle->tangent(wall.front(), chord), upper = circle->tangent(wall.back(), chord);
        return {{"theta1", 180. - std::abs(turn_in_degrees(lower - flat))},
                {"theta2", 180. - std::abs(turn_in_degrees(upper - rim))},
                {"rho", circle->radius},
                {"flange_length", flange_length(wall.back(), upper, flange, rim)}};
      }

      std::string needs() const override
      {
        return "it needs five nodes in the wall, that is between the two margins (Margin), and a mesh that stays in "
               "the last stage";
      }

    private:
      /// Arc lengths between which the sheet is more than the margin away from both ends, by its @p height.
      std::pair<double, double> wall_of(const std::vector<double> &s, const std::vector<double> &height) const
      {
        const auto last = s.size() - 1;
        const double sign = height[last] > height[0] ? 1. : -1.;
        const auto above = [&](const std::size_t i) { return sign * (height[i] - height[0]) - margin_; };
        const auto below = [&](const std::size_t i) { return sign * (height[last] - height[i]) - margin_; };
        std::size_t first = 0, final = last;
        while (first < last && above(first) <= 0.)
          ++first;
        while (final > 0 && below(final) <= 0.)
          --final;
        if (first == 0 || first > final || final == last)
          return {0., 0.};
        const double a = above(first - 1) / (above(first - 1) - above(first)), // above(first - 1) <= 0 < above(first)
          b = below(final) / (below(final) - below(final + 1));
        return {s[first - 1] + a * (s[first] - s[first - 1]), s[final] + b * (s[final + 1] - s[final])};
      }

      /// From where the tangents of wall and flange meet to the end of the blank.
      static double flange_length(const Point2 &wall, const double upper, const std::vector<Point2> &flange,
                                  const double rim)
      {
        // end - l (cos rim, sin rim) = wall + k (cos upper, sin upper)
        const Tensor1 way = flange.back() - wall;
        return (way[1] * std::cos(upper) - way[0] * std::sin(upper)) / std::sin(rim - upper);
      }

      double margin_, leg_;
    };

    const MeasureRegistry::Entry entry("u-bend", "theta1, theta2, rho and flange length of a U-bend, as NUMISHEET'93",
                                       make_as<UBend, Measure>);
  } // namespace
} // namespace deltaform
