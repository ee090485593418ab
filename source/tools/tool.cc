#include <deltaform/tools/tool.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace deltaform
{
  double Tool::force(const double time) const
  {
    Assert(force_driven(), dealii::ExcMessage("A tool with a motion has no given force."));
    return skipped_.value(*force_, time);
  }


  std::pair<double, double> Tool::travel_range(const double begin, const double end) const
  {
    std::pair<double, double> range{travel(begin), travel(begin)};
    constexpr unsigned int n = 16;
    for (unsigned int i = 1; i <= n && !(force_driven() || motion_.is_constant()); ++i)
    {
      const double s = travel(begin + (end - begin) * i / n);
      range = {std::min(range.first, s), std::max(range.second, s)};
    }
    return range;
  }


  const TimeFunction *Tool::allowed_penetration() const
  {
    return allowed_penetration_ ? &*allowed_penetration_ : nullptr;
  }


  bool Tool::exists_in(const std::string &stage) const
  {
    return stages_.empty() || std::find(stages_.begin(), stages_.end(), stage) != stages_.end();
  }


  Projection Tool::project(const Point2 &x, const double travel, const unsigned int hint) const
  {
    const Point2 own(x[0] - position_[0] - travel * direction_[0],
                     mirror_ * (x[1] - position_[1] - travel * direction_[1]));
    Projection p = shape_->project(own, hint);
    p.normal[1] *= mirror_;
    p.tangent[1] *= mirror_;
    return p;
  }


  Point2 Tool::to_scene(const Point2 &own, const double travel) const
  {
    return Point2(position_[0] + travel * direction_[0] + own[0],
                  position_[1] + travel * direction_[1] + mirror_ * own[1]);
  }


  std::vector<Point2> Tool::polyline(const double travel, const double reach, const bool both_sides) const
  {
    std::vector<Point2> points = shape_->polyline(.02, reach, both_sides);
    for (Point2 &point : points)
      point = to_scene(point, travel);
    return points;
  }


  std::pair<Point2, Point2> Tool::bounding_box(const double travel) const
  {
    const auto box = shape_->bounding_box();
    const Point2 a = to_scene(box.first, travel), b = to_scene(box.second, travel);
    return {Point2(a[0], std::min(a[1], b[1])), Point2(b[0], std::max(a[1], b[1]))};
  }
} // namespace deltaform
