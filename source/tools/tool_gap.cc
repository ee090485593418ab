#include <deltaform/tools/tool_gap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    double distance(const std::vector<Point2> &points, const Tool &tool, const double travel)
    {
      double least = std::numeric_limits<double>::infinity();
      unsigned int hint = invalid_index;
      for (const auto &x : points)
      {
        const Projection closest = tool.project(x, travel, hint);
        hint = closest.segment;
        if (std::isfinite(closest.distance))
          least = std::min(least, closest.distance);
      }
      return least;
    }
  } // namespace


  double tool_gap(const Tool &a, const double travel_a, const Tool &b, const double travel_b, const double reach)
  {
    return std::min(distance(a.polyline(travel_a, reach), b, travel_b),
                    distance(b.polyline(travel_b, reach), a, travel_a));
  }
} // namespace deltaform
