#pragma once
// Iterative solvers; private to the solver.
#include <deltaform/solver/linear_method.h>
#include <deltaform/solver/linear_solver.h>

namespace deltaform
{
  enum class Preconditioner
  {
    multigrid, ///< smoothed aggregation
    blocks, ///< on the diagonal, of one node each, which do not care how contact is inclined
    diagonal
  };

  /// A Krylov method of AztecOO.
  class IterativeMethod : public LinearMethod
  {
  public:
    /// @param symmetric conjugate gradients, and GMRES where they fail; else GMRES
    IterativeMethod(const Preconditioner preconditioner, const bool symmetric)
      : preconditioner_(preconditioner), symmetric_(symmetric)
    {
    }

    bool iterative() const override
    {
      return true;
    }

    std::unique_ptr<LinearSolver> make(const LinearSolverSettings &settings,
                                       std::unique_ptr<TrilinosMatrix> matrix) const override;

  private:
    Preconditioner preconditioner_;
    bool symmetric_;
  };
} // namespace deltaform
