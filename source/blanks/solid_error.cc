#include "solid_error.h"
#include "solid_recovery.h"
#include "solid_stress.h"

#include <deltaform/process/ranks.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  ErrorEstimate estimate_error(const SolidDiscretization &body, const MaterialPoints &material)
  {
    const SolidPoints &points = body.points();
    std::vector<std::array<double, 5>> all_computed(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      std::copy_n(material.committed_stress(i).begin(), 4, all_computed[i].begin());
      all_computed[i][4] = material.equivalent_plastic_strain(i);
    }
    const SolidRecovery<5> recovery(body, all_computed);
    const double young = material.law().young_modulus(), nu = material.law().poisson_ratio();
    // The modulus of a plastic point is the secant one: small differences of plastic strain cost little work.
    const auto secant = [&](const unsigned int i) {
      const double stress = mises(material.committed_stress(i)), plastic = all_computed[i][4];
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
      const auto &computed = all_computed[i];
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


  MeshError error_of_flow(const SolidDiscretization &body,
                          const MaterialPoints &material,
                          const std::vector<Mandel> &flow)
  {
    const SolidPoints &points = body.points();
    std::vector<std::array<double, 8>> all_computed(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      std::copy_n(material.committed_stress(i).begin(), 4, all_computed[i].begin());
      std::copy_n(flow[i].begin(), 4, all_computed[i].begin() + 4);
    }
    const SolidRecovery<8> recovery(body, all_computed);
    double work = 0., error = 0.;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      const auto smooth = recovery.smooth(i);
      const auto &computed = all_computed[i];
      double here = 0., off = 0.;
      for (unsigned int k = 0; k < 4; ++k)
      {
        here += computed[k] * computed[k + 4];
        off += (smooth[k] - computed[k]) * (smooth[k + 4] - computed[k + 4]);
      }
      work += points[i].weight * here;
      error += points[i].weight * std::abs(off);
    }
    return {ranks::sum(work), ranks::sum(error)};
  }
} // namespace deltaform
