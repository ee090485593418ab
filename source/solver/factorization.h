#pragma once
// The matrix that a linear solver holds; private to the solver.
#include <deltaform/solver/linear_solver.h>

#include <memory>

namespace deltaform
{
  class Tangent;

  /// The matrix that was handed over to a linear solver last, and solves with it whose result every process knows.
  class Factorization
  {
  public:
    /// @param tangent whose pattern the matrix has, and whose distribution
    Factorization(std::unique_ptr<LinearSolver> solver, const Tangent &tangent);

    LinearSolver &solver()
    {
      return *solver_;
    }

    const LinearSolver &solver() const
    {
      return *solver_;
    }

    /// @param staged values, see Tangent::stage() @return false if the matrix is singular
    bool factorize(const double *staged);

    /// @return false if the solver fails or a number is not finite
    bool solve(const Vector &right_side, Vector &solution);

    /// How many matrices there were.
    unsigned int n() const
    {
      return n_;
    }

  private:
    std::unique_ptr<LinearSolver> solver_;
    const Tangent &tangent_;
    unsigned int n_ = 0;
  };
} // namespace deltaform
