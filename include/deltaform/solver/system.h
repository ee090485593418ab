#pragma once

#include <deltaform/base/assembly_target.h>
#include <deltaform/base/stiffness_view.h>
#include <deltaform/base/types.h>
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
   * The linear system of a Newton iteration. Unknowns [0, n_sparse) live in an Epetra matrix whose pattern and symbolic
   * factorization are kept for the whole run; the few behind them (travels of force-driven tools) couple to many others
   * and are eliminated as blocks with the same factorization. Prescribed unknowns get a row of their own (d = value)
   * and keep their column, so that a prescribed increment moves its neighbours in the same iteration.
   */
  class System : public AssemblyTarget, public StiffnessView
  {
  public:
    /**
     * @param pattern   couplings of the sparse unknowns, n_sparse x n_sparse
     * @param n_border  number of unknowns behind them
     * @param solver    who solves it, and how well
     * @param owned     rows that this process keeps: consecutive, rising with the number of the process; all rows:
     * every process has the whole system for itself
     */
    System(dealii::DynamicSparsityPattern &&pattern,
           unsigned int n_border,
           const LinearSolverSettings &solver,
           const dealii::IndexSet &owned);

    /// A system of this process alone.
    System(dealii::DynamicSparsityPattern &&pattern, unsigned int n_border, const std::string &solver);
    ~System() override;
    System(System &&) noexcept;
    System &operator=(System &&) noexcept;

    unsigned int size() const;

    /**
     * What is added to the tangent up to sum_over_ranks() does not change from pass to pass (the stiffness of a linear
     * blank): it is added in one pass with tangent, and none is wanted for it in later ones. A direct solver then
     * factorizes it once; what is added behind it is an update of low rank, see LowRankUpdate.
     * @param candidates   the sparse unknowns that may get entries behind it; with others the whole is factorized
     * @param largest_rank so it is if more unknowns than this get entries
     */
    void keep_constant_part(std::vector<DofIndex> candidates, std::size_t largest_rank);

    /// Let no earlier matrix have a say in how the next ones are factorized.
    void forget_factors();

    /// Set everything to zero, but for a constant part, and start a pass.
    void clear(bool tangent);

    void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) override;

    /**
     * The end of the part that each process has assembled for its cells: residuals are summed, rows of the matrix go to
     * their owners. What is added from here on is the same on all processes, and counts once.
     */
    void sum_over_ranks();

    bool wants_tangent() const override;

    void block(const DofIndex *dofs, unsigned int n, double *result) const override;

    void multiply(const Vector &direction, Vector &result) const override;

    /// Motions that cost next to no energy (rigid ones), each over the sparse unknowns: an algebraic multigrid has to
    /// represent them.
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
     * Factorize the assembled tangent. @param shift is added to the diagonal (scaled by the diagonal), 0 in general; it
     * changes the path to the solution, not the solution.
     * @return false if the matrix is singular
     */
    bool factorize(double shift = 0.);

    /**
     * Solve K d = -R with d = @p increments on prescribed unknowns.
     * @return false if a number is not finite, or if the border is singular (a force-driven tool that nothing resists)
     */
    bool solve(const Vector &increments, Vector &d);

    /// Why the last solve() failed, if it was not for a singular matrix: in words; otherwise empty.
    std::string linear_failure() const;

    /// Iterations of the linear solver since the start, 0 for a direct one.
    unsigned int n_linear_iterations() const;

    unsigned int n_factorizations() const;

    /// Solves with the constant part alone for its compliance at the unknowns that have been in an update.
    unsigned int n_compliances() const;

  private:
    bool factorize_whole(double shift);

    std::unique_ptr<Tangent> tangent_;
    std::unique_ptr<PrescribedRows> rows_;
    std::unique_ptr<Factorization> factorization_;
    std::unique_ptr<ConstantPart> constant_; ///< null if the whole tangent changes from pass to pass
    bool wanted_ = true; ///< the tangent is assembled in this pass
    bool common_ = false; ///< what is added now is the same on all processes
    Vector residual_, magnitude_;
  };
} // namespace deltaform
