#include <deltaform/increment/damping.h>
#include <deltaform/solver/system.h>

namespace deltaform
{
  Damping::Damping(System &system, const std::vector<double> &scale)
    : system_(system), scale_(scale)
  {
  }


  double Damping::work_along(const Vector &d) const
  {
    double work = 0.;
    for (unsigned int i = 0; i < d.size(); ++i)
      if (!system_.prescribed(i))
        work += d[i] * system_.residual()[i];
    return work;
  }


  bool Damping::descend(Vector &d, const std::function<bool()> &assemble, const std::function<bool(double)> &solve)
  {
    constexpr unsigned int most_attempts = 30;
    const double work = work_along(d);
    if (work <= 0. && c_ == 0.)
      return true;
    if (c_ == 0.)
    {
      // -d.K.d / d.M.d of the step: the size of the negative eigenvalues that it follows.
      double square = 0.;
      for (unsigned int i = 0; i < d.size(); ++i)
        if (!system_.prescribed(i))
          square += d[i] * d[i] * scale_[i] * scale_[i];
      c_ = work / square;
    }
    bool solved = false;
    for (unsigned int attempt = 0; attempt < most_attempts; ++attempt)
    {
      if (!assemble())
        return false;
      system_.add_to_diagonal(c_, scale_);
      // With one negative eigenvalue alone the first c makes the matrix exactly singular.
      solved = solve(1e-12);
      if (solved && work_along(d) <= 0.)
        break;
      c_ *= 4.;
    }
    return solved;
  }


  void Damping::relax(const bool better)
  {
    if (better)
      c_ *= .25;
    if (c_ > 0. && c_ < 1e-14 * system_.largest_diagonal())
      c_ = 0.;
  }
} // namespace deltaform
