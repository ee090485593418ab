// Damped steps, for increments in which the blank snaps through.
#include <deltaform/solver/newton.h>

#include <algorithm>

namespace deltaform
{
  double Newton::work_along(const Vector &d, const std::vector<bool> &is_prescribed) const
  {
    double work = 0.;
    for (unsigned int i = 0; i < d.size(); ++i)
      if (!is_prescribed[i])
        work += d[i] * system_.residual()[i];
    return work;
  }


  bool Newton::descend(const Vector &q, const std::vector<bool> &is_prescribed, const Vector &increments, Vector &d)
  {
    double work = work_along(d, is_prescribed);
    if (work <= 0. && damping_ == 0.)
      return true;
    if (damping_ == 0.)
    {
      // -d.K.d / d.M.d of the step: the size of the negative eigenvalues that it follows.
      double square = 0.;
      for (unsigned int i = 0; i < d.size(); ++i)
        if (!is_prescribed[i])
          square += d[i] * d[i] * scale_[i] * scale_[i];
      damping_ = work / square;
    }
    for (unsigned int attempt = 0; attempt < 30; ++attempt)
    {
      problem_.assemble(q, true);
      system_.add_to_diagonal(damping_, scale_);
      {
        Timers::Scope timer(timers_, timer_solve_);
        if (!system_.factorize(1e-12) || !system_.solve(increments, d))
          return false;
      }
      work = work_along(d, is_prescribed);
      if (work <= 0.)
        break;
      damping_ *= 4.;
    }
    return true;
  }
} // namespace deltaform
