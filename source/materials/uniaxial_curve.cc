#include <deltaform/materials/uniaxial_curve.h>

#include <algorithm>
#include <array>
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
        : law_(law), committed_(law.history_size(), 0.), trial_(committed_)
      {
      }

      /// Pull to the axial @p strain. @return is there a lateral strain without lateral stress?
      bool pull(const double strain)
      {
        constexpr unsigned int most_iterations = 50;
        const double tolerance = 1e-10 * law_.young_modulus();
        for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
        {
          if (!evaluate(strain))
            return false;
          if (std::abs(stress_[1]) < tolerance)
          {
            committed_ = trial_;
            return true;
          }
          lateral_ -= stress_[1] / tangent_[5];
        }
        return false;
      }

      UniaxialPoint point() const
      {
        return {law_.equivalent_plastic_strain(committed_.data()),
                tangent_[0] - tangent_[1] * tangent_[4] / tangent_[5]};
      }

    private:
      bool evaluate(const double strain)
      {
        Mandel e{{strain, lateral_, 0., 0.}};
        MaterialBatch batch;
        batch.n_points = 1;
        batch.third_direction = ThirdDirection::stress_given;
        batch.strain = &e;
        batch.third_stress = &no_stress_;
        batch.committed = committed_.data();
        batch.duration = 1.;
        batch.trial = trial_.data();
        batch.stress = &stress_;
        batch.tangent = tangent_.data();
        return law_.update(batch).good();
      }

      const Material &law_;
      double lateral_ = 0., no_stress_ = 0.;
      Mandel stress_{};
      std::array<double, 16> tangent_{};
      std::vector<double> committed_, trial_;
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
