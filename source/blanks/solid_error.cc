// Where the solid's mesh is too coarse: stresses against recovered ones (doc/theory/solid.md).
#include "solid_stress.h"

#include <deltaform/blanks/solid.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  Solid::ErrorEstimate Solid::estimate_error() const
  {
    // Stresses and equivalent plastic strain, fitted by polynomials on the cells around every vertex (O.C. Zienkiewicz,
    // J.Z. Zhu, Int. J. Numer. Methods Eng. 33 (1992) 1331 and 1365), and blended between the vertices of a cell.
    constexpr unsigned int n_values = 5;
    using Fit                       = Eigen::MatrixXd;
    const unsigned int n_points     = n_points_per_cell_;
    const unsigned int n_terms      = degree_ == 1 ? 3 : 6;
    const double young = material_->young_modulus(), nu = material_->poisson_ratio();

    std::vector<Point2> places(points_.size());
    std::vector<std::array<double, n_values>> values(points_.size());
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
        places[i] += points_[i].shape[a] * nodes_[cells_[i / n_points][a]];
      std::copy_n(committed_stress_[i].begin(), 4, values[i].begin());
      values[i][4] = material_->equivalent_plastic_strain(history_.committed(i));
    }
    std::vector<std::vector<unsigned int>> around(nodes_.size());
    for (unsigned int c = 0; c < cells_.size(); ++c)
      for (unsigned int v = 0; v < 4; ++v)
        around[cells_[c][v]].push_back(c);

    std::vector<Fit> fits(nodes_.size());
    std::vector<double> size(nodes_.size(), 0.);
    const auto terms = [&](const unsigned int node, const Point2 &X)
    {
      const Tensor1 d = (X - nodes_[node]) / size[node];
      Eigen::VectorXd result(n_terms);
      result.head(3) << 1., d[0], d[1];
      if (n_terms == 6)
        result.tail(3) << d[0] * d[0], d[0] * d[1], d[1] * d[1];
      return result;
    };
    for (unsigned int node = 0; node < nodes_.size(); ++node)
    {
      const auto &patch = around[node];
      if (patch.empty())
        continue;
      for (const auto c : patch)
        size[node] = std::max(size[node], nodes_[cells_[c][0]].distance(nodes_[cells_[c][3]]));
      Eigen::MatrixXd A(patch.size() * n_points, n_terms), b(patch.size() * n_points, n_values);
      for (unsigned int k = 0; k < A.rows(); ++k)
      {
        const unsigned int i = patch[k / n_points] * n_points + k % n_points;
        A.row(k)             = terms(node, places[i]).transpose();
        b.row(k)             = Eigen::Map<const Eigen::RowVectorXd>(values[i].data(), n_values);
      }
      fits[node] = A.colPivHouseholderQr().solve(b);
    }

    // The modulus of a plastic point is the secant one: small differences of plastic strain cost little work.
    const auto secant = [&](const unsigned int i)
    {
      const double stress = mises(committed_stress_[i]), plastic = values[i][4];
      return plastic > 0 ? stress / (stress / young + plastic) : 0.;
    };
    const auto energy = [&](const Mandel &t)
    {
      const double trace = t[0] + t[1] + t[2];
      return (1 + nu) / young * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + t[3] * t[3]) - nu / young * trace * trace;
    };
    ErrorEstimate result;
    result.squares.assign(cells_.size(), 0.);
    double all = 0., errors = 0.;
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      const auto &cell          = cells_[i / n_points];
      Eigen::RowVectorXd smooth = Eigen::RowVectorXd::Zero(n_values);
      for (unsigned int v = 0; v < 4; ++v)
        smooth += corner_shape(i % n_points, v) * (terms(cell[v], places[i]).transpose() * fits[cell[v]]);
      Mandel difference;
      for (unsigned int k = 0; k < 4; ++k)
        difference[k] = smooth[k] - values[i][k];
      const double plastic = smooth[4] - values[i][4], w = points_[i].weight;
      const double square = w * (energy(difference) + secant(i) * plastic * plastic);
      result.squares[i / n_points] += square;
      errors += square;
      all += w * (energy(committed_stress_[i]) + secant(i) * values[i][4] * values[i][4]);
    }
    result.relative = all > 0 ? std::sqrt(errors / all) : 0.;
    return result;
  }


  double Solid::corner_shape(const unsigned int point, const unsigned int vertex) const
  {
    const double x = quadrature_[point][0], y = quadrature_[point][1];
    return (vertex % 2 == 0 ? 1 - x : x) * (vertex / 2 == 0 ? 1 - y : y);
  }
} // namespace deltaform
