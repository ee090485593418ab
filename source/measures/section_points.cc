#include "section_points.h"

#include <deal.II/base/numbers.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace deltaform
{
  std::vector<double> column_of(const Table &table, const std::string &name)
  {
    const auto column = std::find(table.names.begin(), table.names.end(), name);
    if (column == table.names.end())
      throw std::out_of_range("no column " + name);
    std::vector<double> result;
    for (const auto &row : table.rows)
      result.push_back(row[static_cast<std::size_t>(column - table.names.begin())]);
    return result;
  }


  std::vector<Point2> points_of(const Table &profile)
  {
    const auto r = column_of(profile, "r"), z = column_of(profile, "z");
    std::vector<Point2> result;
    for (std::size_t i = 0; i < r.size(); ++i)
      result.emplace_back(r[i], z[i]);
    return result;
  }


  namespace
  {
    /// Place at an arc length, on the parabola through the three nodes around it (two: on the line).
    Point2 point_at(const std::vector<double> &s, const std::vector<Point2> &points, const double place)
    {
      const auto above = static_cast<std::size_t>(std::upper_bound(s.begin(), s.end(), place) - s.begin());
      const std::size_t n = std::min<std::size_t>(3, s.size());
      const std::size_t first = std::min(above > 0 ? above - 1 : 0, s.size() - n);
      Point2 result;
      for (std::size_t i = first; i < first + n; ++i)
      {
        double share = 1.;
        for (std::size_t k = first; k < first + n; ++k)
          if (k != i)
            share *= (place - s[k]) / (s[i] - s[k]);
        result += share * (points[i] - Point2());
      }
      return result;
    }
  } // namespace


  std::vector<Point2> points_between(const Table &profile, const double from, const double to)
  {
    const auto place = column_of(profile, "S0");
    const auto rows = points_of(profile);
    // A corner that two faces of a mesh share has two rows.
    std::vector<double> s;
    std::vector<Point2> all;
    for (std::size_t i = 0; i < place.size(); ++i)
      if (s.empty() || place[i] > s.back())
      {
        s.push_back(place[i]);
        all.push_back(rows[i]);
      }
    if (s.size() < 2)
      return {};
    const double begin = std::max(from, s.front()), end = std::min(to, s.back());
    if (!(begin < end))
      return {};
    std::vector<Point2> result{point_at(s, all, begin)};
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s[i] > begin && s[i] < end)
        result.push_back(all[i]);
    result.push_back(point_at(s, all, end));
    return result;
  }


  double Circle::tangent(const Point2 &point, const double along) const
  {
    const double angle = direction(center, point) + .5 * dealii::numbers::PI;
    return std::cos(angle - along) > 0. ? angle : angle + dealii::numbers::PI;
  }


  std::optional<Circle> fit_circle(const std::vector<Point2> &points)
  {
    if (points.size() < 3)
      return std::nullopt;
    // From the mean: far from the origin the squares have no digits left.
    Point2 mean;
    for (const auto &x : points)
      mean += (x - Point2()) / static_cast<double>(points.size());
    Eigen::MatrixX3d rows(points.size(), 3);
    Eigen::VectorXd squares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Tensor1 x = points[i] - mean;
      rows.row(static_cast<Eigen::Index>(i)) << x[0], x[1], 1.;
      squares[static_cast<Eigen::Index>(i)] = x.norm_square();
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> factors(rows);
    if (factors.rank() < 3)
      return std::nullopt;
    const Eigen::Vector3d c = factors.solve(squares);
    return Circle{mean + Tensor1({.5 * c[0], .5 * c[1]}), std::sqrt(c[2] + .25 * (c[0] * c[0] + c[1] * c[1]))};
  }


  double direction(const Point2 &first, const Point2 &last)
  {
    return std::atan2(last[1] - first[1], last[0] - first[0]);
  }


  double turn_in_degrees(const double angle)
  {
    const double degrees = angle * 180. / dealii::numbers::PI;
    return degrees - 360. * std::floor((degrees + 180.) / 360.);
  }
} // namespace deltaform
