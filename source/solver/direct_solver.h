#pragma once
// Direct solvers; private to the solver.
#include <deltaform/solver/linear_method.h>
#include <deltaform/solver/linear_solver.h>

#include <string>
#include <utility>

namespace deltaform
{
  /// A factorization by a library that Amesos knows.
  class DirectMethod : public LinearMethod
  {
  public:
    explicit DirectMethod(std::string library)
      : library_(std::move(library))
    {
    }

    bool iterative() const override
    {
      return false;
    }

    std::unique_ptr<LinearSolver> make(const LinearSolverSettings &settings,
                                       std::unique_ptr<TrilinosMatrix> matrix) const override;

  private:
    std::string library_;
  };
} // namespace deltaform
