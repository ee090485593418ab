#include <deltaform/materials/forming_limit.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace deltaform
{
  FormingLimit::FormingLimit(std::vector<Point> points)
    : points_(std::move(points))
  {
    if (points_.empty())
      throw std::invalid_argument("must have at least one point");
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
      const std::string which = "at the minor strain " + text::format(points_[i].minor) + " ";
      if (i > 0 && !(points_[i].minor > points_[i - 1].minor))
        throw std::invalid_argument(which + "it is no function: the minor strain must increase from point to point");
      // Equal strains may differ by round-off.
      if (!(points_[i].major > 0. && points_[i].major > (1. - 1e-9) * points_[i].minor))
        throw std::invalid_argument(which + "the major strain must be positive and no less than the minor one");
    }
  }


  double FormingLimit::major(const double minor) const
  {
    const auto right = std::find_if(points_.begin(), points_.end(), [&](const Point &p) { return p.minor >= minor; });
    if (right == points_.end() || points_.size() == 1)
      return points_.back().major;
    const auto b = right == points_.begin() ? right + 1 : right, a = b - 1;
    const double slope = (b->major - a->major) / (b->minor - a->minor);
    if (right == points_.begin() && slope > 0.)
      return a->major;
    return a->major + slope * (minor - a->minor);
  }


  double FormingLimit::along(const double ratio) const
  {
    // On the ray, limit - major strain is positive at the origin; it is linear in the major strain between corners.
    std::vector<double> corners;
    for (const Point &point : points_)
      if (ratio != 0. && point.minor / ratio > 0.)
        corners.push_back(point.minor / ratio);
    std::sort(corners.begin(), corners.end());
    const auto room = [&](const double major_strain) { return major(ratio * major_strain) - major_strain; };
    double before = 0., room_before = room(0.);
    corners.push_back(corners.empty() ? 1. : 2. * corners.back() + 1.);
    for (const double corner : corners)
    {
      const double here = room(corner), slope = (here - room_before) / (corner - before);
      const bool last = corner == corners.back();
      if (here <= 0. || (last && slope < 0.))
        return before - room_before / slope;
      before = corner;
      room_before = here;
    }
    return std::numeric_limits<double>::infinity();
  }


  std::unique_ptr<FormingLimit> read_forming_limit(const Section &scene, const Material &law)
  {
    Section section = scene.sub("Limits").sub("forming limit");
    return FormingLimits::choose(section,
                                 "Curve",
                                 "marciniak-kuczynski",
                                 "Forming limit curve: major strain at which the sheet necks, over the minor strain.",
                                 law);
  }
} // namespace deltaform
