#include <deltaform/materials/point_field.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  bool keeps_its_heat(const Material &law)
  {
    return !law.heat() && law.history_layout().find("temperature_rise") != nullptr;
  }


  double largest_principal(const Mandel &stress)
  {
    const double middle = .5 * (stress[0] + stress[1]), half = .5 * (stress[0] - stress[1]);
    return std::max(stress[2], middle + std::sqrt(half * half + .5 * stress[3] * stress[3]));
  }


  double triaxiality(const Mandel &stress)
  {
    const double mean = (stress[0] + stress[1] + stress[2]) / 3.;
    double norm = stress[3] * stress[3];
    for (unsigned int k = 0; k < 3; ++k)
      norm += (stress[k] - mean) * (stress[k] - mean);
    const double mises = std::sqrt(1.5 * norm);
    return mises > 0. ? mean / mises : 0.;
  }
} // namespace deltaform
