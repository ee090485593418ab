#pragma once
// Points of a section, and what is fitted to them; private to the measures.
#include <deltaform/assembly/types.h>
#include <deltaform/io/table.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /// Column of a table by its name. @throws std::out_of_range
  std::vector<double> column_of(const Table &table, const std::string &name);

  /// r and z of the rows.
  std::vector<Point2> points_of(const Table &profile);

  /// Those whose initial arc length lies between two, with points at both ends between the nodes, so that the mesh does
  /// not choose them; on the blank only. None if @p from is not before @p to there.
  std::vector<Point2> points_between(const Table &profile, double from, double to);

  struct Circle
  {
    Point2 center;
    double radius;

    /// Direction of the tangent at @p point (rad), the one that is nearer to @p along.
    double tangent(const Point2 &point, double along) const;
  };

  /// Least algebraic distance, r^2 + z^2 = a r + b z + c (I. Kasa, IEEE Trans. Instrum. Meas. 25 (1976) 8). Nothing if
  /// the points lie on a line or are fewer than three.
  std::optional<Circle> fit_circle(const std::vector<Point2> &points);

  /// Direction from the first to the last point (rad).
  double direction(const Point2 &first, const Point2 &last);

  /// @p angle (rad) in degrees, in [-180, 180).
  double turn_in_degrees(double angle);
} // namespace deltaform
