#pragma once
// The matrix and the vectors that the linear solvers share; private to them.
#include <deltaform/solver/linear_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

namespace deltaform
{
  /// The library objects, kept for the whole run.
  struct TrilinosMatrix
  {
    /// All rows here.
    explicit TrilinosMatrix(const dealii::DynamicSparsityPattern &pattern);

    /// Rows [first, end) here.
    TrilinosMatrix(const dealii::DynamicSparsityPattern &pattern, DofIndex first, DofIndex end);

    dealii::TrilinosWrappers::SparseMatrix whole;
    std::unique_ptr<Epetra_CrsMatrix> part;
    Epetra_CrsMatrix *crs = nullptr; ///< one of the two
    std::unique_ptr<Epetra_Vector> solution, right_side;
    std::unique_ptr<Epetra_LinearProblem> problem;
    bool is_distributed = false;

    /// The same answer on all processes.
    bool all(bool good) const;

  private:
    void make_vectors();
  };
} // namespace deltaform
