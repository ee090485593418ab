#include "plane_stress_points.h"

#include <deltaform/materials/uniaxial_curve.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// One point of the law under uniaxial stress.
    class Bar
    {
    public:
      explicit Bar(const Material &law)
        : metal_(law), tolerance_(1e-10 * law.young_modulus())
      {
      }

      /// Pull to the axial @p strain. @return is there a lateral strain without lateral stress?
      bool pull(const double strain)
      {
        constexpr unsigned int most_iterations = 50;
        for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
        {
          metal_.strain() = {{strain, lateral_, 0., 0.}};
          if (!metal_.update())
            return false;
          if (std::abs(metal_.stress()[1]) < tolerance_)
          {
            metal_.accept();
            return true;
          }
          lateral_ -= metal_.stress()[1] / metal_.tangent()[5];
        }
        return false;
      }

      UniaxialPoint point() const
      {
        const double *const C = metal_.tangent();
        return {metal_.equivalent_plastic_strain(), C[0] - C[1] * C[4] / C[5]};
      }

    private:
      PlaneStressPoints metal_;
      double tolerance_, lateral_ = 0.;
    };
  } // namespace


  std::vector<UniaxialPoint> uniaxial_curve(const Material &law)
  {
    Bar bar(law);
    std::vector<UniaxialPoint> result;
    constexpr double smallest = 1e-5, growth = 1.05, largest = 1.;
    for (double strain = smallest; strain < largest && bar.pull(strain); strain = growth * strain + smallest)
      if (const UniaxialPoint point = bar.point();
          result.empty() || point.plastic_strain > result.back().plastic_strain)
        result.push_back(point);
    return result;
  }


  double tangent_modulus(const std::vector<UniaxialPoint> &curve, const double plastic_strain)
  {
    const auto above = std::lower_bound(
      curve.begin(), curve.end(), plastic_strain,
      [](const UniaxialPoint &point, const double value) { return point.plastic_strain < value; });
    if (above == curve.begin())
      return curve.front().modulus;
    if (above == curve.end())
      return curve.back().modulus;
    const auto below = above - 1;
    const double share = (plastic_strain - below->plastic_strain) / (above->plastic_strain - below->plastic_strain);
    return (1. - share) * below->modulus + share * above->modulus;
  }
} // namespace deltaform
