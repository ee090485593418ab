// Amesos: the symbolic phase is done once, because the pattern does not change.
#include "trilinos_matrix.h"

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class DirectSolver : public LinearSolver
    {
    public:
      DirectSolver(const std::string &name, std::unique_ptr<TrilinosMatrix> matrix)
        : matrix_(std::move(matrix)),
          factorization_(Amesos().Create(name == "mumps" ? "Mumps" : "Klu", *matrix_->problem))
      {
        AssertThrow(factorization_, dealii::ExcMessage("This Trilinos has no Amesos solver '" + name + "'."));
        Teuchos::ParameterList list;
        list.set("PrintTiming", false);
        list.set("PrintStatus", false);
        factorization_->SetParameters(list);
      }

      Epetra_CrsMatrix &matrix() override
      {
        return *matrix_->crs;
      }

      bool factorize() override
      {
        if (!analysed_ && !matrix_->all(factorization_->SymbolicFactorization() == 0))
          return false;
        analysed_ = true;
        return matrix_->all(factorization_->NumericFactorization() == 0);
      }

      bool solve(const double *right_side, double *solution) override
      {
        const int n = matrix_->right_side->MyLength();
        std::copy(right_side, right_side + n, matrix_->right_side->Values());
        if (!matrix_->all(factorization_->Solve() == 0))
          return false;
        std::copy(matrix_->solution->Values(), matrix_->solution->Values() + n, solution);
        return true;
      }

    private:
      std::unique_ptr<TrilinosMatrix> matrix_;
      std::unique_ptr<Amesos_BaseSolver> factorization_;
      bool analysed_ = false;
    };
  } // namespace


  std::unique_ptr<LinearSolver> make_direct_solver(const LinearSolverSettings &settings,
                                                   std::unique_ptr<TrilinosMatrix> matrix)
  {
    return std::make_unique<DirectSolver>(settings.name, std::move(matrix));
  }
} // namespace deltaform
