#include <deltaform/increment/step_damping.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    // doc/decisions/README.md, "Steps along what nothing resists"
    constexpr double near_equilibrium = 1e-3; ///< relative residual
    constexpr double cut = .5; ///< share of a step that is taken
    constexpr unsigned int in_a_row = 2; ///< one may be where metal begins or ceases to flow
    constexpr double share_of_increment = .05; ///< a longer step is no correction of it
    constexpr double growth = 4.; ///< of the radius after a step that is not cut
    constexpr double all = .5; ///< share of the radius: a step that needs all of it is longer
  } // namespace


  double StepDamping::radius(const double residual) const
  {
    return residual <= near_equilibrium ? radius_ : std::numeric_limits<double>::infinity();
  }


  bool StepDamping::bound(const double residual, const double length, const double way)
  {
    if (residual > near_equilibrium || std::isfinite(radius_) || way <= 0. || length <= share_of_increment * way)
      return false;
    radius_ = share_of_increment * way;
    return true;
  }


  bool StepDamping::shorten(const double residual, const double most)
  {
    if (residual > near_equilibrium)
      return false;
    radius_ = std::min(radius_ / growth, most);
    return true;
  }


  void StepDamping::judge(const double residual, const double factor, const double length)
  {
    if (residual > near_equilibrium)
      return;
    n_cut_ = factor < cut ? n_cut_ + 1 : 0;
    if (n_cut_ >= in_a_row)
      radius_ = factor * length;
    else if (n_cut_ == 0 && length > all * radius_)
      radius_ *= growth;
  }


  void StepDamping::loosen()
  {
    radius_ *= growth;
  }
} // namespace deltaform
