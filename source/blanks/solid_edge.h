#pragma once

#include <deltaform/assembly/types.h>

#include <array>

namespace deltaform
{
  /// Nodes of an edge of a solid's boundary, walked with the body to the left: start, end, middle (degree 2).
  using Edge = std::array<unsigned int, 3>;

  /// Point of the quadrature of an edge: shape functions of its start, end and middle, derivatives, weight.
  struct EdgePoint
  {
    std::array<double, 3> shape, gradient;
    double weight;
  };

  /// Shape functions at a place of an edge, @p xi from 0 to 1; the weight is 1.
  EdgePoint edge_point(unsigned int degree, double xi);

  /// Gauss rule with three points: exact for shape function, radius and length of a straight edge of degree 2.
  const std::array<EdgePoint, 3> &edge_quadrature(unsigned int degree);

  /// Shares of the area of an edge with its nodes at @p x: shape functions times 2 pi r ds (plane strain: ds).
  std::array<double, 3> edge_areas(const std::array<Point2, 3> &x, unsigned int degree, bool axisymmetric);
} // namespace deltaform
