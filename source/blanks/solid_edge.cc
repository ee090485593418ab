#include "solid_edge.h"

#include <cmath>

namespace deltaform
{
  EdgePoint edge_point(const unsigned int degree, const double xi)
  {
    if (degree == 1)
      return {{{1 - xi, xi, 0.}}, {{-1., 1., 0.}}, 1.};
    return {{{(1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1), 4 * xi * (1 - xi)}},
            {{4 * xi - 3, 4 * xi - 1, 4 - 8 * xi}},
            1.};
  }


  namespace
  {
    std::array<EdgePoint, 3> make_rule(const unsigned int degree)
    {
      std::array<EdgePoint, 3> result;
      const double distance = .5 * std::sqrt(.6);
      for (unsigned int k = 0; k < 3; ++k)
      {
        const double x = .5 + (k - 1.) * distance;
        result[k] = edge_point(degree, x);
        result[k].weight = k == 1 ? 4. / 9. : 5. / 18.;
      }
      return result;
    }
  } // namespace


  const std::array<EdgePoint, 3> &edge_quadrature(const unsigned int degree)
  {
    static const std::array<std::array<EdgePoint, 3>, 2> rules{{make_rule(1), make_rule(2)}};
    return rules[degree - 1];
  }


  std::array<double, 3>
  edge_areas(const std::array<Point2, 3> &x, const unsigned int degree, const bool axisymmetric)
  {
    std::array<double, 3> result{};
    for (const auto &[shape, gradient, weight] : edge_quadrature(degree))
    {
      Tensor1 x_xi;
      double r = 0;
      for (unsigned int a = 0; a <= degree; ++a)
      {
        x_xi += gradient[a] * x[a];
        r += shape[a] * x[a][0];
      }
      const double dA = (axisymmetric ? 2 * dealii::numbers::PI * r : 1.) * x_xi.norm() * weight;
      for (unsigned int a = 0; a <= degree; ++a)
        result[a] += shape[a] * dA;
    }
    return result;
  }
} // namespace deltaform
