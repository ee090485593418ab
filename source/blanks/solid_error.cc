#include "solid_error.h"
#include "solid_stress.h"

#include <deltaform/process/ranks.h>

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


    /// Smooth stresses and equivalent plastic strain, from the points of the cells around every vertex.
    class Recovery
    {
    public:
      using Values = Eigen::RowVectorXd;

      Recovery(const SolidDiscretization &body, const MaterialPoints &material)
        : space_(body.space()), points_(body.points()), n_terms_(space_.degree() == 1 ? 3 : 6),
          samples_(points_.size()), fits_(space_.nodes().size()), size_(space_.nodes().size(), 0.)
      {
        for (unsigned int i = 0; i < points_.size(); ++i)
        {
          const auto &cell = space_.cells()[i / points_.per_cell()];
          const Point2 place = points_.place(i);
          samples_[i].place = {{place[0], place[1]}};
          std::copy_n(cell.begin(), 4, samples_[i].corners.begin());
          std::copy_n(material.committed_stress(i).begin(), 4, samples_[i].values.begin());
          samples_[i].values[4] = material.equivalent_plastic_strain(i);
        }
        add_neighbours(samples_, space_.nodes().size());
        fit();
      }

      /// As computed, at an own point.
      const std::array<double, n_values> &computed(const unsigned int point) const
      {
        return samples_[point].values;
      }

      /// As recovered, at an own point.
      Values smooth(const unsigned int point) const
      {
        const auto &cell = space_.cells()[point / points_.per_cell()];
        const Point2 &unit = points_.unit_points()[point % points_.per_cell()];
        Values result = Values::Zero(n_values);
        for (unsigned int v = 0; v < 4; ++v)
          result += corner_shape(unit, v) * (terms(cell[v], place(point)).transpose() * fits_[cell[v]]);
        return result;
      }

    private:
      /// Bilinear function of a corner of the unit cell.
      static double corner_shape(const Point2 &unit, const unsigned int vertex)
      {
        const double x = unit[0], y = unit[1];
        return (vertex % 2 == 0 ? 1 - x : x) * (vertex / 2 == 0 ? 1 - y : y);
      }

      Point2 place(const unsigned int sample) const
      {
        return {samples_[sample].place[0], samples_[sample].place[1]};
      }

      /// Of the polynomial around a vertex.
      Eigen::VectorXd terms(const unsigned int node, const Point2 &X) const
      {
        const Tensor1 d = (X - space_.nodes()[node]) / size_[node];
        Eigen::VectorXd result(n_terms_);
        result.head(3) << 1., d[0], d[1];
        if (n_terms_ == 6)
          result.tail(3) << d[0] * d[0], d[0] * d[1], d[1] * d[1];
        return result;
      }

      /// First samples of the cells around every vertex of an own cell.
      std::vector<std::vector<unsigned int>> patches() const
      {
        std::vector<std::vector<unsigned int>> around(space_.nodes().size());
        for (unsigned int i = 0; i < samples_.size(); i += points_.per_cell())
          for (const auto corner : samples_[i].corners)
            if (i < points_.size() || !around[corner].empty())
              around[corner].push_back(i);
        return around;
      }

      void fit()
      {
        const unsigned int n_points = points_.per_cell();
        const auto around = patches();
        for (unsigned int node = 0; node < space_.nodes().size(); ++node)
        {
          const auto &patch = around[node];
          if (patch.empty())
            continue;
          for (const auto i : patch)
          {
            const auto &corners = samples_[i].corners;
            size_[node] =
              std::max(size_[node], space_.nodes()[corners[0]].distance(space_.nodes()[corners[3]]));
          }
          Eigen::MatrixXd A(patch.size() * n_points, n_terms_), b(patch.size() * n_points, n_values);
          for (unsigned int k = 0; k < A.rows(); ++k)
          {
            const unsigned int i = patch[k / n_points] + k % n_points;
            A.row(k) = terms(node, place(i)).transpose();
            b.row(k) = Eigen::Map<const Values>(samples_[i].values.data(), n_values);
          }
          fits_[node] = A.colPivHouseholderQr().solve(b);
        }
      }

      const SolidSpace &space_;
      const SolidPoints &points_;
      unsigned int n_terms_;
      std::vector<Sample> samples_;
      std::vector<Eigen::MatrixXd> fits_; ///< of the vertices of own cells
      std::vector<double> size_; ///< of the cells around a vertex
    };
  } // namespace


  ErrorEstimate estimate_error(const SolidDiscretization &body, const MaterialPoints &material)
  {
    const Recovery recovery(body, material);
    const SolidPoints &points = body.points();
    const double young = material.law().young_modulus(), nu = material.law().poisson_ratio();
    // The modulus of a plastic point is the secant one: small differences of plastic strain cost little work.
    const auto secant = [&](const unsigned int i) {
      const double stress = mises(material.committed_stress(i)), plastic = recovery.computed(i)[4];
      return plastic > 0 ? stress / (stress / young + plastic) : 0.;
    };
    const auto energy = [&](const Mandel &t) {
      const double trace = t[0] + t[1] + t[2];
      return (1 + nu) / young * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + t[3] * t[3]) - nu / young * trace * trace;
    };
    ErrorEstimate result;
    result.squares.assign(body.space().cells().size(), 0.);
    double all = 0., errors = 0.;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const auto smooth = recovery.smooth(i);
      const auto &computed = recovery.computed(i);
      Mandel difference;
      for (unsigned int k = 0; k < 4; ++k)
        difference[k] = smooth[k] - computed[k];
      const double plastic = smooth[4] - computed[4], w = points[i].weight;
      const double square = w * (energy(difference) + secant(i) * plastic * plastic);
      result.squares[i / points.per_cell()] += square;
      errors += square;
      all += w * (energy(material.committed_stress(i)) + secant(i) * computed[4] * computed[4]);
    }
    all = ranks::sum(all);
    result.relative = all > 0 ? std::sqrt(ranks::sum(errors) / all) : 0.;
    // Cells that are alike by symmetry stay so: the last digits depend on the number of processes.
    for (auto &square : result.squares)
      square = static_cast<float>(square);
    return result;
  }
} // namespace deltaform
