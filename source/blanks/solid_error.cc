// Where the solid's mesh is too coarse: stresses against recovered ones (doc/theory/solid.md).
#include "solid.h"
#include "solid_stress.h"

#include <deltaform/base/ranks.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int n_values = 5;

    /// A quadrature point, sent byte by byte: stresses and equivalent plastic strain, and the corners of its cell.
    struct Sample
    {
      std::array<double, 2> place;
      std::array<double, n_values> values;
      std::array<unsigned int, 4> corners;
      unsigned int process = 0;
    };

    /// Behind the own points come those of other processes' cells that have a corner in common with own ones.
    void add_neighbours(std::vector<Sample> &samples, const unsigned int n_nodes)
    {
      if (ranks::count() == 1)
        return;
      std::vector<double> mine(n_nodes, 0.);
      for (const auto &sample : samples)
        for (const auto corner : sample.corners)
          mine[corner] = 1.;
      std::vector<double> all = mine;
      ranks::sum(all.data(), all.size());
      std::vector<Sample> shared;
      for (auto &sample : samples)
        sample.process = ranks::mine();
      std::copy_if(samples.begin(),
                   samples.end(),
                   std::back_inserter(shared),
                   [&](const Sample &sample) {
                     const auto &c = sample.corners;
                     return std::any_of(c.begin(), c.end(), [&](const unsigned int node) { return all[node] > 1.; });
                   });
      for (const auto &sample : ranks::gather(shared))
      {
        const auto &c = sample.corners;
        if (sample.process != ranks::mine() &&
            std::any_of(c.begin(), c.end(), [&](const unsigned int node) { return mine[node] > 0.; }))
          samples.push_back(sample);
      }
    }
  } // namespace


  Solid::ErrorEstimate Solid::estimate_error() const
  {
    // Stresses and equivalent plastic strain, fitted by polynomials on the cells around every vertex (O.C. Zienkiewicz,
    // J.Z. Zhu, Int. J. Numer. Methods Eng. 33 (1992) 1331 and 1365), and blended between the vertices of a cell.
    using Fit = Eigen::MatrixXd;
    const unsigned int n_points = points_.per_cell();
    const unsigned int n_terms = space_.degree() == 1 ? 3 : 6;
    const double young = material_.law().young_modulus(), nu = material_.law().poisson_ratio();

    std::vector<Sample> samples(points_.size());
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      const auto &cell = space_.cells()[i / n_points];
      const Point2 place = points_.place(i);
      samples[i].place = {{place[0], place[1]}};
      std::copy_n(cell.begin(), 4, samples[i].corners.begin());
      std::copy_n(material_.committed_stress(i).begin(), 4, samples[i].values.begin());
      samples[i].values[4] = material_.equivalent_plastic_strain(i);
    }
    add_neighbours(samples, space_.nodes().size());
    const auto place = [&](const unsigned int i) { return Point2(samples[i].place[0], samples[i].place[1]); };
    std::vector<std::vector<unsigned int>> around(space_.nodes().size());
    for (unsigned int i = 0; i < samples.size(); i += n_points)
      for (const auto corner : samples[i].corners)
        if (i < points_.size() || !around[corner].empty())
          around[corner].push_back(i);

    std::vector<Fit> fits(space_.nodes().size());
    std::vector<double> size(space_.nodes().size(), 0.);
    const auto terms = [&](const unsigned int node, const Point2 &X) {
      const Tensor1 d = (X - space_.nodes()[node]) / size[node];
      Eigen::VectorXd result(n_terms);
      result.head(3) << 1., d[0], d[1];
      if (n_terms == 6)
        result.tail(3) << d[0] * d[0], d[0] * d[1], d[1] * d[1];
      return result;
    };
    for (unsigned int node = 0; node < space_.nodes().size(); ++node)
    {
      const auto &patch = around[node];
      if (patch.empty())
        continue;
      for (const auto i : patch)
        size[node] =
          std::max(size[node], space_.nodes()[samples[i].corners[0]].distance(space_.nodes()[samples[i].corners[3]]));
      Eigen::MatrixXd A(patch.size() * n_points, n_terms), b(patch.size() * n_points, n_values);
      for (unsigned int k = 0; k < A.rows(); ++k)
      {
        const unsigned int i = patch[k / n_points] + k % n_points;
        A.row(k) = terms(node, place(i)).transpose();
        b.row(k) = Eigen::Map<const Eigen::RowVectorXd>(samples[i].values.data(), n_values);
      }
      fits[node] = A.colPivHouseholderQr().solve(b);
    }

    // The modulus of a plastic point is the secant one: small differences of plastic strain cost little work.
    const auto secant = [&](const unsigned int i) {
      const double stress = mises(material_.committed_stress(i)), plastic = samples[i].values[4];
      return plastic > 0 ? stress / (stress / young + plastic) : 0.;
    };
    const auto energy = [&](const Mandel &t) {
      const double trace = t[0] + t[1] + t[2];
      return (1 + nu) / young * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + t[3] * t[3]) - nu / young * trace * trace;
    };
    ErrorEstimate result;
    result.squares.assign(space_.cells().size(), 0.);
    double all = 0., errors = 0.;
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      const auto &cell = space_.cells()[i / n_points];
      Eigen::RowVectorXd smooth = Eigen::RowVectorXd::Zero(n_values);
      for (unsigned int v = 0; v < 4; ++v)
        smooth += corner_shape(i % n_points, v) * (terms(cell[v], place(i)).transpose() * fits[cell[v]]);
      Mandel difference;
      for (unsigned int k = 0; k < 4; ++k)
        difference[k] = smooth[k] - samples[i].values[k];
      const double plastic = smooth[4] - samples[i].values[4], w = points_[i].weight;
      const double square = w * (energy(difference) + secant(i) * plastic * plastic);
      result.squares[i / n_points] += square;
      errors += square;
      all += w * (energy(material_.committed_stress(i)) + secant(i) * samples[i].values[4] * samples[i].values[4]);
    }
    all = ranks::sum(all);
    result.relative = all > 0 ? std::sqrt(ranks::sum(errors) / all) : 0.;
    // Cells that are alike by symmetry stay so: the last digits depend on the number of processes.
    for (auto &square : result.squares)
      square = static_cast<float>(square);
    return result;
  }


  double Solid::corner_shape(const unsigned int point, const unsigned int vertex) const
  {
    const double x = points_.unit_points()[point][0], y = points_.unit_points()[point][1];
    return (vertex % 2 == 0 ? 1 - x : x) * (vertex / 2 == 0 ? 1 - y : y);
  }
} // namespace deltaform
