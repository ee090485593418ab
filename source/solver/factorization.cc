#include "factorization.h"

#include "tangent.h"

#include <cmath>
#include <utility>

namespace deltaform
{
  Factorization::Factorization(std::unique_ptr<LinearSolver> solver, const Tangent &tangent)
    : solver_(std::move(solver)), tangent_(tangent)
  {
  }


  bool Factorization::factorize(const double *const staged)
  {
    ++n_;
    tangent_.hand_over(staged);
    return solver_->factorize();
  }


  bool Factorization::solve(const Vector &right_side, Vector &solution)
  {
    if (!solver_->solve(right_side.begin() + tangent_.first(), solution.begin() + tangent_.first()))
      return false;
    tangent_.share(solution);
    for (unsigned int i = 0; i < tangent_.n_sparse(); ++i)
      if (!std::isfinite(solution[i]))
        return false;
    return true;
  }
} // namespace deltaform
