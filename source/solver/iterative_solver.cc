// Krylov methods for large solids. Algebraic multigrid by smoothed aggregation needs the motions that cost no energy,
// for elasticity the rigid ones: Vanek, Mandel, Brezina (1996), Computing 56, 179-196. A penalty along an inclined
// normal makes both unknowns of a node stiff, and one combination of them soft: what smooths or scales must take them
// together.
#include "iterative_solver.h"

#include "trilinos_matrix.h"

#include <deltaform/parameters/text.h>

#include <AztecOO.h>
#include <Ifpack.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class IterativeSolver : public LinearSolver
    {
    public:
      IterativeSolver(const LinearSolverSettings &settings,
                      const Preconditioner preconditioner,
                      const bool symmetric,
                      std::unique_ptr<TrilinosMatrix> matrix)
        : tolerance_(settings.tolerance), max_iterations_(static_cast<int>(settings.max_iterations)),
          matrix_(std::move(matrix)), kind_(preconditioner), symmetric_(symmetric)
      {
      }

      Epetra_CrsMatrix &matrix() override
      {
        return *matrix_->crs;
      }

      void set_near_null_space(const std::vector<Vector> &motions, const DofIndex first, const DofIndex end) override
      {
        null_space_.clear();
        for (const auto &motion : motions)
          null_space_.insert(null_space_.end(), motion.begin() + first, motion.begin() + end);
        n_motions_ = static_cast<int>(motions.size());
      }

      bool factorize() override
      {
        if (kind_ == Preconditioner::blocks)
          return matrix_->all(invert_blocks());
        if (kind_ != Preconditioner::multigrid)
          return true;
        Teuchos::ParameterList list;
        ML_Epetra::SetDefaults("SA", list);
        list.set("ML output", 0);
        list.set("aggregation: type", "Uncoupled");
        list.set("smoother: type", "symmetric Gauss-Seidel");
        // Coarse levels have three unknowns, the motions of an aggregate, and no single node's contact.
        if (matrix_->all(matrix_->crs->NumMyRows() % 2 == 0))
          list.set("smoother: type (level 0)", "symmetric block Gauss-Seidel");
        list.set("smoother: sweeps", 2);
        list.set("coarse: type", "Amesos-KLU");
        list.set("coarse: max size", 2000);
        list.set("PDE equations", 2);
        if (n_motions_ > 0)
        {
          list.set("null space: type", "pre-computed");
          list.set("null space: dimension", n_motions_);
          list.set("null space: vectors", null_space_.data());
        }
        preconditioner_.reset();
        preconditioner_ = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(*matrix_->crs, list, true);
        return matrix_->all(preconditioner_->IsPreconditionerComputed());
      }

      bool solve(const double *right_side, double *solution) override
      {
        const int n = matrix_->right_side->MyLength();
        std::copy(right_side, right_side + n, matrix_->right_side->Values());
        double norm = 0.;
        matrix_->right_side->Norm2(&norm);
        matrix_->solution->PutScalar(0.);
        // An indefinite tangent ends conjugate gradients: GMRES goes on.
        failure_.clear();
        bool good = norm == 0. || (symmetric_ && iterate(AZ_cg));
        if (!good)
        {
          matrix_->solution->PutScalar(0.);
          good = iterate(AZ_gmres);
        }
        std::copy(matrix_->solution->Values(), matrix_->solution->Values() + n, solution);
        return matrix_->all(good);
      }

      std::string failure() const override
      {
        return failure_;
      }

      unsigned int n_iterations() const override
      {
        return n_iterations_;
      }

    private:
      /// The blocks of two unknowns on the diagonal, one per node.
      bool invert_blocks()
      {
        const int n = matrix_->crs->NumMyRows();
        Teuchos::ParameterList list;
        list.set("relaxation: type", "Jacobi");
        list.set("partitioner: type", "linear");
        list.set("partitioner: local parts", (n + 1) / 2);
        block_diagonal_.reset(Ifpack().Create("block relaxation stand-alone", matrix_->crs, 0));
        return block_diagonal_->SetParameters(list) == 0 && block_diagonal_->Initialize() == 0 &&
               block_diagonal_->Compute() == 0;
      }

      bool iterate(const int method)
      {
        AztecOO solver(*matrix_->problem);
        solver.SetAztecOption(AZ_solver, method);
        solver.SetAztecOption(AZ_output, AZ_none);
        solver.SetAztecOption(AZ_conv, AZ_rhs);
        solver.SetAztecOption(AZ_kspace, 100);
        if (kind_ == Preconditioner::multigrid)
          solver.SetPrecOperator(preconditioner_.get());
        else if (kind_ == Preconditioner::blocks)
          solver.SetPrecOperator(block_diagonal_.get());
        else
        {
          solver.SetAztecOption(AZ_precond, AZ_Jacobi);
          solver.SetAztecOption(AZ_poly_ord, 1);
        }
        solver.Iterate(max_iterations_, tolerance_);
        n_iterations_ += static_cast<unsigned int>(solver.NumIters());
        const double why = solver.GetAztecStatus()[AZ_why];
        if (why == AZ_maxits)
          failure_ = std::string(method == AZ_cg ? "conjugate gradients" : "GMRES") + " stopped after " +
                     std::to_string(solver.NumIters()) + " iterations at " + text::rounded(solver.ScaledResidual()) +
                     " of the right side, wanted is " + text::format(tolerance_);
        // The recursive residual has converged, the true one has reached its round-off: as good as it gets.
        return why == AZ_normal || why == AZ_loss;
      }

      double tolerance_;
      int max_iterations_;
      std::unique_ptr<TrilinosMatrix> matrix_;
      Preconditioner kind_;
      bool symmetric_; ///< conjugate gradients first
      int n_motions_ = 0;
      std::vector<double> null_space_;
      std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> preconditioner_;
      std::unique_ptr<Ifpack_Preconditioner> block_diagonal_;
      unsigned int n_iterations_ = 0;
      std::string failure_; ///< of the last solve
    };
  } // namespace


  std::unique_ptr<LinearSolver> IterativeMethod::make(const LinearSolverSettings &settings,
                                                      std::unique_ptr<TrilinosMatrix> matrix) const
  {
    return std::make_unique<IterativeSolver>(settings, preconditioner_, symmetric_, std::move(matrix));
  }
} // namespace deltaform
