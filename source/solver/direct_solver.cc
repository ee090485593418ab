// Amesos: the symbolic phase is done once, because the pattern does not change; pivots are kept as long as they are
// good.
#include "direct_solver.h"

#include "trilinos_matrix.h"

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace deltaform
{
  namespace
  {
    class DirectSolver : public LinearSolver
    {
    public:
      DirectSolver(const std::string &name, std::unique_ptr<TrilinosMatrix> matrix)
        : matrix_(std::move(matrix)), keeps_pivots_(name == "Klu" && !matrix_->is_distributed),
          factorization_(Amesos().Create(name, *matrix_->problem))
      {
        AssertThrow(factorization_, dealii::ExcMessage("This Trilinos has no Amesos solver '" + name + "'."));
        Teuchos::ParameterList list;
        list.set("PrintTiming", false);
        list.set("PrintStatus", false);
        // KLU would divide rows by their sums before it looks for pivots, also when it keeps them: half as long again.
        if (name == "Klu")
          list.set("ScaleMethod", -1);
        factorization_->SetParameters(list);
        int *columns = nullptr;
        matrix_->crs->ExtractCrsDataPointers(row_start_, columns, values_);
        columns_ = columns;
      }

      Epetra_CrsMatrix &matrix() override
      {
        return *matrix_->crs;
      }

      bool is_cheap() const override
      {
        return keeps_pivots_;
      }

      void discard_factors() override
      {
        factored_.clear();
        has_pivots_ = false;
      }

      bool factorize() override
      {
        const std::size_t n = row_start_[matrix_->crs->NumMyRows()];
        // The matrix of the last time, to the last bit, has the factors of the last time: linear problems.
        const bool same = factored_.size() == n && std::equal(factored_.begin(), factored_.end(), values_);
        if (matrix_->all(same))
          return true;
        factored_.clear();
        if (!analysed_ && !matrix_->all(factorization_->SymbolicFactorization() == 0))
          return false;
        reuse_pivots(keeps_pivots_ && has_pivots_);
        analysed_ = has_pivots_ = true;
        if (!matrix_->all(factorization_->NumericFactorization() == 0))
          return false;
        factored_.assign(values_, values_ + n);
        return true;
      }

      bool solve(const double *right_side, double *solution) override
      {
        const int n = matrix_->right_side->MyLength();
        std::copy(right_side, right_side + n, matrix_->right_side->Values());
        if (!matrix_->all(factorization_->Solve() == 0))
          return false;
        if (reuses_pivots_ && !accurate())
        {
          reuse_pivots(false);
          if (factorization_->NumericFactorization() != 0 || factorization_->Solve() != 0)
            return false;
        }
        std::copy(matrix_->solution->Values(), matrix_->solution->Values() + n, solution);
        return true;
      }

    private:
      /// Factorize with the pivots of the last time, without a search for new ones?
      void reuse_pivots(const bool reuse)
      {
        if (reuse == reuses_pivots_)
          return;
        reuses_pivots_ = reuse;
        Teuchos::ParameterList list;
        list.set("Refactorize", reuse);
        factorization_->SetParameters(list);
      }

      /**
       * Old pivots may be bad ones of the new matrix, which no factorization notices. The backward error of the
       * solution does: the smallest relative change of matrix and right side whose exact solution it is (W. Oettli,
       * W. Prager, Numer. Math. 6 (1964) 405), 1e-16 to 1e-14 with good pivots.
       */
      bool accurate() const
      {
        constexpr double allowed = 1e-12;
        const double *const x = matrix_->solution->Values(), *const b = matrix_->right_side->Values();
        double worst = 0., largest = 0.;
        for (int i = 0; i < matrix_->crs->NumMyRows(); ++i)
        {
          double residual = b[i], size = std::abs(b[i]);
          for (int k = row_start_[i]; k < row_start_[i + 1]; ++k)
          {
            const double product = values_[k] * x[columns_[k]];
            residual -= product;
            size += std::abs(product);
          }
          if (!std::isfinite(residual))
            return false;
          worst = std::max(worst, std::abs(residual));
          largest = std::max(largest, size);
        }
        return worst <= allowed * largest;
      }

      std::unique_ptr<TrilinosMatrix> matrix_;
      bool keeps_pivots_;
      std::unique_ptr<Amesos_BaseSolver> factorization_;
      bool analysed_ = false, has_pivots_ = false, reuses_pivots_ = false;
      int *row_start_ = nullptr; ///< of the matrix, as the next two
      const int *columns_ = nullptr;
      double *values_ = nullptr;
      std::vector<double> factored_; ///< values of the last good factorization; empty: there is none
    };
  } // namespace


  std::unique_ptr<LinearSolver> DirectMethod::make(const LinearSolverSettings &,
                                                   std::unique_ptr<TrilinosMatrix> matrix) const
  {
    return std::make_unique<DirectSolver>(library_, std::move(matrix));
  }
} // namespace deltaform
