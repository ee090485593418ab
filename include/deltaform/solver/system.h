#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/assembly/types.h>
#include <deltaform/solver/linear_solver.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  class ConstantPart;
  class Factorization;
  class PrescribedRows;
  class Tangent;

  /**
   * The linear system K d = -R of a Newton iteration. Unknowns [0, n_sparse) belong to an Epetra matrix, whose pattern
   * and symbolic factorization are kept for the whole run. The few unknowns behind them, the border (travels of
   * force-driven tools), couple to many others; they are eliminated with the same factorization. The row of a
   * prescribed unknown becomes d = value; its column stays, so that a prescribed increment moves its neighbours in the
   * same iteration. Derivation: doc/theory/solver.md.
   */
  class System : public AssemblyTarget, public StiffnessView
  {
  public:
    /**
     * @param pattern   couplings of the sparse unknowns, n_sparse x n_sparse
     * @param n_border  number of unknowns in the border
     * @param solver    linear solver and its tolerance
     * @param owned     rows of this process: consecutive, rising with the number of the process. All rows: every
     *                  process has the whole system for itself
     */
    System(dealii::DynamicSparsityPattern &&pattern,
           unsigned int n_border,
           const LinearSolverSettings &solver,
           const dealii::IndexSet &owned);

    /// A system for this process alone.
    System(dealii::DynamicSparsityPattern &&pattern, unsigned int n_border, const std::string &solver);
    ~System() override;
    System(System &&) noexcept;
    System &operator=(System &&) noexcept;

    unsigned int size() const;

    /**
     * The part of the tangent that is added before sum_over_ranks() is the same in every pass (the stiffness of a
     * linear blank). It is added in the first pass with a tangent only. A direct solver factorizes it once; what is
     * added after sum_over_ranks() is an update of low rank (LowRankUpdate). The whole matrix is factorized instead if
     * unknowns outside of @p candidates get entries after sum_over_ranks(), or more than @p largest_rank do.
     */
    void keep_constant_part(std::vector<DofIndex> candidates, std::size_t largest_rank);

    /// Discard what earlier factorizations left (pivots): see LinearSolver::discard_factors().
    void discard_factors();

    /// Start a pass: set everything to zero but a constant part.
    void clear(bool tangent);

    void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) override;

    /**
     * Every process has assembled its own cells: sum the residuals, send rows of the matrix to their owners. What is
     * added from here on is the same on all processes, and counts once.
     */
    void sum_over_ranks();

    bool wants_tangent() const override;

    /**
     * Remember what this pass has added so far, so that parts behind it can be added differently without doing the rest
     * again. @return false: it is not worth it, because a factorization is dearer than a pass, or not possible (several
     * processes, a constant part)
     */
    bool keep();

    /// Go on with the pass from what was kept in it. @return false: nothing was
    bool go_back();

    void block(const DofIndex *dofs, unsigned int n, double *result) const override;

    void multiply(const Vector &direction, Vector &result) const override;

    /// @p result = R + K @p d, border included; not after factorize(). Where d is a solution it is zero but in rows of
    /// prescribed unknowns.
    void linear_residual(const Vector &d, Vector &result) const;

    /// Rigid motions, each over the sparse unknowns: an algebraic multigrid has to represent them.
    void set_near_null_space(const std::vector<Vector> &motions);

    /// Which unknowns are prescribed.
    void set_prescribed(const std::vector<bool> &prescribed);

    bool prescribed(DofIndex dof) const;

    /// Visit the entries (row, column, value) of the tangent as assembled, border included; not after factorize().
    void for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const;

    /// R, with the reactions in the rows of prescribed unknowns.
    const Vector &residual() const
    {
      return residual_;
    }

    /// Sum of the absolute contributions to each row: the scale against which R is judged.
    const Vector &magnitude() const
    {
      return magnitude_;
    }

    /// Add @p factor scale^2 to the diagonal of the sparse unknowns of the assembled tangent.
    void add_to_diagonal(double factor, const std::vector<double> &scale);

    /// Diagonal entry of the tangent of a sparse unknown; 0 for the others.
    double diagonal(DofIndex dof) const;

    /// Largest diagonal entry of the tangent.
    double largest_diagonal() const;

    /**
     * Factorize the assembled tangent. @return false if it is singular
     * @param shift times the diagonal is added to the diagonal; 0 in general. It changes the path to the solution, not
     *              the solution
     */
    bool factorize(double shift = 0.);

    /**
     * Solve K d = -R with d = @p increments on prescribed unknowns.
     * @return false if a number is not finite, or if the border is singular (a force-driven tool that nothing resists)
     */
    bool solve(const Vector &increments, Vector &d);

    /// Why the last solve() failed although the matrix was not singular, in words; empty if it did not.
    std::string linear_failure() const;

    /// Iterations of the linear solver since the start, 0 for a direct one.
    unsigned int n_linear_iterations() const;

    unsigned int n_factorizations() const;

    /// Number of solves with the constant part alone, one per unknown that has ever been in an update.
    unsigned int n_compliances() const;

  private:
    struct Kept;

    bool factorize_whole(double shift);

    std::unique_ptr<Tangent> tangent_;
    std::unique_ptr<PrescribedRows> rows_;
    std::unique_ptr<Factorization> factorization_;
    std::unique_ptr<ConstantPart> constant_; ///< null if the whole tangent changes from pass to pass
    bool wanted_ = true; ///< the tangent is assembled in this pass
    bool common_ = false; ///< what is added now is the same on all processes
    Vector residual_, magnitude_;
    std::unique_ptr<Kept> kept_; ///< null: nothing was kept
  };
} // namespace deltaform
