#include "cell_cut.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Lagrange's polynomials of the points of Gauss's rule of a cell, at a place.
    std::vector<double> point_weights(const std::vector<Point2> &points, const Point2 &xi)
    {
      const auto n = static_cast<unsigned int>(std::lround(std::sqrt(points.size())));
      std::vector<double> result;
      const auto line = [&](const unsigned int i, const double x) {
        double product = 1.;
        for (unsigned int k = 0; k < n; ++k)
          if (k != i)
            product *= (x - points[k][0]) / (points[i][0] - points[k][0]);
        return product;
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          result.push_back(line(i, xi[0]) * line(j, xi[1]));
      return result;
    }
  } // namespace


  CellCut::CellCut(const unsigned int degree, const std::size_t n_state, const Material &law)
    : shapes_(degree), n_nodes_(shapes_.n_dofs_per_cell()), n_state_(n_state), law_(law),
      unit_points_(dealii::QGauss<2>(degree + 1).get_points())
  {
  }


  CellCut::Data
  CellCut::cut(const std::vector<CellPlace> &nodes, const std::vector<CellPlace> &points, const double margin) const
  {
    Data result;
    add_nodes(nodes, result);
    if (law_.history_size() > 0)
      for (const CellPlace &place : points)
        add_state(place, margin, result);
    else
      result.resize(result.size() + points.size() * n_state_, 0.);
    return result;
  }


  void CellCut::add_nodes(const std::vector<CellPlace> &nodes, Data &result) const
  {
    const std::size_t n_vectors = (nodes.front().cell->size() - unit_points_.size() * n_state_) / (2 * n_nodes_);
    result.assign(2 * n_vectors * nodes.size(), 0.);
    for (std::size_t b = 0; b < nodes.size(); ++b)
    {
      const Data &from = *nodes[b].cell;
      for (unsigned int a = 0; a < n_nodes_; ++a)
      {
        double weight = shapes_.shape_value(a, nodes[b].xi);
        if (const double round = std::round(weight); std::abs(weight - round) < 1e-13)
          weight = round; // old nodes keep their numbers exactly
        for (std::size_t v = 0; v < n_vectors; ++v)
          for (unsigned int k = 0; k < 2; ++k)
            result[2 * (v * nodes.size() + b) + k] += weight * from[2 * (v * n_nodes_ + a) + k];
      }
    }
  }


  void CellCut::add_state(const CellPlace &place, const double margin, Data &result) const
  {
    // Interpolated between the old points, towards their mean as far as the equivalent plastic strain would leave the
    // range that a linear one with these values has where points may lie, or get negative. The logarithm of C_p^-1 has
    // no trace, whatever the weights.
    const std::size_t n_points = unit_points_.size();
    const double *const first = place.cell->data() + place.cell->size() - n_points * n_state_;
    const auto equivalent = [&](const double *const state) { return law_.equivalent_plastic_strain(state); };
    const auto weights = point_weights(unit_points_, place.xi);
    Data mean(n_state_, 0.), state(n_state_, 0.);
    double least = equivalent(first), most = least;
    for (std::size_t p = 0; p < n_points; ++p)
    {
      const double *const at_point = first + p * n_state_;
      least = std::min(least, equivalent(at_point));
      most = std::max(most, equivalent(at_point));
      for (std::size_t k = 0; k < n_state_; ++k)
      {
        mean[k] += at_point[k] / n_points;
        state[k] += weights[p] * at_point[k];
      }
    }
    const double middle = equivalent(mean.data()), value = equivalent(state.data());
    const double outermost = unit_points_.front()[0], reach = (outermost - margin) / (1. - 2. * outermost);
    const double range = most - least;
    most += reach * range;
    least = std::max(0., least - reach * range);
    // A little less, so that round-off does not make a strain negative.
    const double part = value > most    ? (1. - 1e-14) * (most - middle) / (value - middle)
                        : value < least ? (1. - 1e-14) * (least - middle) / (value - middle)
                                        : 1.;
    for (std::size_t k = 0; k < n_state_; ++k)
      result.push_back(part == 1. ? state[k] : mean[k] + part * (state[k] - mean[k]));
  }
} // namespace deltaform
