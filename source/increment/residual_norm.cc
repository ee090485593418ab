#include <deltaform/increment/residual_norm.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  ResidualNorm::ResidualNorm(const System &system, const std::vector<double> &scale, const std::vector<double> &size,
                             const std::vector<bool> &is_prescribed, const double floor, const double tolerance)
    : system_(system), scale_(scale), size_(size), is_prescribed_(is_prescribed), floor_(floor), tolerance_(tolerance)
  {
  }


  double ResidualNorm::relative()
  {
    constexpr double epsilon = 8 * std::numeric_limits<double>::epsilon();
    double square = 0., magnitude = 0., noise = 0., worst = -1.;
    for (unsigned int i = 0; i < scale_.size(); ++i)
    {
      const double m = system_.magnitude()[i] / scale_[i];
      magnitude += m * m;
      if (is_prescribed_[i])
        continue;
      const double round_off = epsilon * system_.diagonal(i) * size_[i] / scale_[i];
      noise += round_off * round_off;
      const double r = system_.residual()[i] / scale_[i];
      square += r * r;
      if (std::abs(r) > worst)
      {
        worst = std::abs(r);
        worst_dof_ = i;
      }
    }
    magnitude_ = std::max({std::sqrt(magnitude), floor_, std::sqrt(noise) / tolerance_});
    return std::sqrt(square) / magnitude_;
  }
} // namespace deltaform
