#include "cell_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace deltaform
{
  namespace
  {
    double distance_from(const std::array<Point2, 2> &box, const Point2 &X)
    {
      const double r = std::max({box[0][0] - X[0], 0., X[0] - box[1][0]});
      const double z = std::max({box[0][1] - X[1], 0., X[1] - box[1][1]});
      return std::hypot(r, z);
    }
  } // namespace


  CellSearch::CellSearch(const unsigned int degree, std::vector<std::vector<double>> cells)
    : shapes_(degree), n_nodes_(shapes_.n_dofs_per_cell()), cells_(std::move(cells))
  {
    for (const auto &cell : cells_)
      boxes_.push_back(box_around(cell));
  }


  CellSearch::Box CellSearch::box_around(const std::vector<double> &cell) const
  {
    Box box{{{cell[0], cell[1]}, {cell[0], cell[1]}}};
    for (unsigned int a = 1; a < n_nodes_; ++a)
      for (unsigned int k = 0; k < 2; ++k)
      {
        box[0][k] = std::min(box[0][k], cell[2 * a + k]);
        box[1][k] = std::max(box[1][k], cell[2 * a + k]);
      }
    return box;
  }


  Point2 CellSearch::place(const std::vector<double> &cell, const Point2 &xi) const
  {
    Point2 X;
    for (unsigned int a = 0; a < n_nodes_; ++a)
      X += shapes_.shape_value(a, xi) * Tensor1({cell[2 * a], cell[2 * a + 1]});
    return X;
  }


  Point2 CellSearch::unit_place(const std::vector<double> &cell, const Point2 &X) const
  {
    constexpr unsigned int most_iterations = 20;
    Point2 xi(.5, .5);
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
    {
      Tensor2 jacobian;
      for (unsigned int a = 0; a < n_nodes_; ++a)
      {
        const Tensor1 gradient = shapes_.shape_grad(a, xi);
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            jacobian[i][j] += cell[2 * a + i] * gradient[j];
      }
      if (!(dealii::determinant(jacobian) > 0.))
        break;
      const Tensor1 step = dealii::invert(jacobian) * (X - place(cell, xi));
      for (unsigned int k = 0; k < 2; ++k)
        xi[k] = std::clamp(xi[k] + step[k], -1., 2.); // further away it is another cell's
      if (step.norm() < 1e-14)
        break;
    }
    return {std::clamp(xi[0], 0., 1.), std::clamp(xi[1], 0., 1.)};
  }


  CellPlace CellSearch::find(const Point2 &X, double &distance) const
  {
    CellPlace best{nullptr, {}};
    distance = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < cells_.size(); ++c)
    {
      if (distance_from(boxes_[c], X) >= distance)
        continue;
      const Point2 xi = unit_place(cells_[c], X);
      if (const double away = place(cells_[c], xi).distance(X); away < distance)
      {
        distance = away;
        best = {&cells_[c], xi};
      }
    }
    return best;
  }
} // namespace deltaform
