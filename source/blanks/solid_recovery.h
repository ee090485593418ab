#pragma once

#include "solid_discretization.h"

#include <deltaform/process/ranks.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace deltaform
{
  /**
   * Smooth fields from values at the quadrature points of a solid: polynomials (degree 1: linear, degree 2: quadratic)
   * fitted to the points of the cells around every vertex, blended by the bilinear functions of a cell (O.C.
   * Zienkiewicz, J.Z. Zhu, Int. J. Numer. Methods Eng. 33 (1992) 1331 and 1365).
   */
  template <unsigned int n_values>
  class SolidRecovery
  {
  public:
    using Values = std::array<double, n_values>;

    /// @param values of the own points. All processes together
    SolidRecovery(const SolidDiscretization &body, const std::vector<Values> &values)
      : space_(body.space()), points_(body.points()), n_terms_(space_.degree() == 1 ? 3 : 6), samples_(values.size()),
        fits_(space_.nodes().size()), size_(space_.nodes().size(), 0.)
    {
      for (unsigned int i = 0; i < samples_.size(); ++i)
      {
        const auto &cell = space_.cells()[i / points_.per_cell()];
        const Point2 place = points_.place(i);
        samples_[i].place = {{place[0], place[1]}};
        samples_[i].values = values[i];
        std::copy_n(cell.begin(), 4, samples_[i].corners.begin());
      }
      add_neighbours();
      fit();
    }

    /// At an own point.
    Values smooth(const unsigned int point) const
    {
      const Point2 &unit = points_.unit_points()[point % points_.per_cell()];
      Values result;
      Eigen::Map<Row> row(result.data());
      row.setZero();
      for (unsigned int v = 0; v < 4; ++v)
      {
        const unsigned int node = samples_[point].corners[v];
        row += corner_shape(unit, v) * (terms(node, samples_[point]).transpose() * fits_[node]);
      }
      return result;
    }

  private:
    static constexpr int most_terms = 6;
    using Row = Eigen::Matrix<double, 1, n_values>;
    using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;
    using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_terms>;
    using Fit = Eigen::Matrix<double, Eigen::Dynamic, n_values, 0, most_terms, n_values>;

    /// A quadrature point, sent byte by byte: its values, and the corners of its cell.
    struct Sample
    {
      std::array<double, 2> place;
      Values values;
      std::array<unsigned int, 4> corners;
      unsigned int process = 0;
    };

    /// Bilinear function of a corner of the unit cell.
    static double corner_shape(const Point2 &unit, const unsigned int vertex)
    {
      const double x = unit[0], y = unit[1];
      return (vertex % 2 == 0 ? 1 - x : x) * (vertex / 2 == 0 ? 1 - y : y);
    }

    /// Of the polynomial around a vertex.
    Terms terms(const unsigned int node, const Sample &sample) const
    {
      const Point2 &X = space_.nodes()[node];
      const double x = (sample.place[0] - X[0]) / size_[node], y = (sample.place[1] - X[1]) / size_[node];
      Terms result(n_terms_);
      result.template head<3>() << 1., x, y;
      if (n_terms_ == most_terms)
        result.template tail<3>() << x * x, x * y, y * y;
      return result;
    }

    /// Behind the own points come those of other processes' cells that have a corner in common with own ones.
    void add_neighbours()
    {
      if (ranks::count() == 1)
        return;
      std::vector<double> mine(size_.size(), 0.);
      for (const auto &sample : samples_)
        for (const auto corner : sample.corners)
          mine[corner] = 1.;
      std::vector<double> all = mine;
      ranks::sum(all.data(), all.size());
      const auto has_corner = [](const Sample &sample, const std::vector<double> &marks, const double above) {
        return std::any_of(sample.corners.begin(), sample.corners.end(), [&](const unsigned int node) {
          return marks[node] > above;
        });
      };
      std::vector<Sample> shared;
      for (auto &sample : samples_)
        sample.process = ranks::mine();
      std::copy_if(samples_.begin(), samples_.end(), std::back_inserter(shared), [&](const Sample &sample) {
        return has_corner(sample, all, 1.);
      });
      for (const auto &sample : ranks::gather(shared))
        if (sample.process != ranks::mine() && has_corner(sample, mine, 0.))
          samples_.push_back(sample);
    }

    void fit()
    {
      for (const auto &sample : samples_)
        for (const auto node : sample.corners)
          size_[node] = std::max(size_[node],
                                 space_.nodes()[sample.corners[0]].distance(space_.nodes()[sample.corners[3]]));
      std::vector<Normal> normal(fits_.size(), Normal::Zero(n_terms_, n_terms_));
      std::fill(fits_.begin(), fits_.end(), Fit::Zero(n_terms_, n_values));
      for (const auto &sample : samples_)
        for (const auto node : sample.corners)
        {
          const Terms t = terms(node, sample);
          normal[node] += t * t.transpose();
          fits_[node] += t * Eigen::Map<const Row>(sample.values.data());
        }
      for (unsigned int node = 0; node < fits_.size(); ++node)
        if (size_[node] > 0.)
          fits_[node] = Fit(normal[node].ldlt().solve(fits_[node]));
    }

    const SolidSpace &space_;
    const SolidPoints &points_;
    int n_terms_;
    std::vector<Sample> samples_;
    std::vector<Fit> fits_; ///< of the vertices of own cells
    std::vector<double> size_; ///< of the cells around a vertex
  };
} // namespace deltaform
