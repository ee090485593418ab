#pragma once

#include <deltaform/base/assembly_target.h>
#include <deltaform/base/stiffness_view.h>
#include <deltaform/base/types.h>
#include <deltaform/solver/entry_places.h>
#include <deltaform/solver/linear_solver.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
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

    /// Discard what is kept from earlier factorizations (pivots): see LinearSolver::forget().
    void forget_factors();

    /// Start a pass: set everything to zero but a constant part.
    void clear(bool tangent);

    void add(const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) override;

    /**
     * Every process has assembled its own cells: sum the residuals, send rows of the matrix to their owners. What is
     * added from here on is the same on all processes, and counts once.
     */
    void sum_over_ranks();

    bool wants_tangent() const override;

    void block(const DofIndex *dofs, unsigned int n, double *result) const override;

    void multiply(const Vector &direction, Vector &result) const override;

    /// Rigid motions, each over the sparse unknowns: an algebraic multigrid has to represent them.
    void set_near_null_space(const std::vector<Vector> &motions);

    /// Which unknowns are prescribed.
    void set_prescribed(const std::vector<bool> &prescribed);

    bool prescribed(const DofIndex dof) const
    {
      return prescribed_[dof];
    }

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

    unsigned int n_factorizations() const
    {
      return n_factorizations_;
    }

    /// Number of solves with the constant part alone, one per unknown that has ever been in an update.
    unsigned int n_compliances() const;

  private:
    struct Rows;
    struct Constant;

    /// Storage for the rows of this process, and for the others that its cells contribute to.
    void distribute(dealii::DynamicSparsityPattern &pattern, const dealii::IndexSet &owned);

    bool owns(const DofIndex row) const
    {
      return !rows_ || (row >= first_ && row < end_);
    }

    /// Index of an entry in the array of values; EntryPlaces::nowhere if it is not stored.
    int place(DofIndex row, DofIndex column) const;

    double *entry(DofIndex row, DofIndex column) const;

    /// Find the places of the diagonal, which is read in every iteration.
    void find_diagonal();

    /// Add to an entry that is not stored here.
    void add_elsewhere(DofIndex row, DofIndex column, double value);

    bool solve_sparse(const Vector &right_side, Vector &solution);

    /// The array in which the matrix for the solver is prepared: a copy of the tangent, or the tangent itself where it
    /// is not needed any more.
    double *stage();

    /// Eliminate the rows (and columns, where the elimination is symmetric) of prescribed unknowns in a staged matrix,
    /// whose largest diagonal entry is @p scale, and shift its diagonal.
    void eliminate(double *staged, double scale, double shift);

    /// Give a staged matrix to the solver: distributed rows are copied, others are there already.
    void hand_over(const double *staged);

    bool factorize_whole(double shift);

    /// Factorize constant part and update. @return false if the update is not of low rank, or singular
    bool factorize_constant();

    /// Restore the constant part: remove what has been added to it.
    void restore_constant();

    bool solve_condensed(const Vector &increments, Vector &d);

    /// -R less the eliminated columns times their increments; in rows of prescribed unknowns the increment itself.
    void right_side(const Vector &increments, Vector &result) const;

    unsigned int n_sparse_, n_border_;
    DofIndex first_ = 0, end_; ///< own rows
    std::unique_ptr<LinearSolver> solver_;
    std::unique_ptr<Rows> rows_; ///< null if all rows are here
    std::unique_ptr<Constant> constant_; ///< null if the whole tangent changes from pass to pass
    bool symmetric_elimination_; ///< of prescribed unknowns: what an iterative solver needs
    bool common_ = false; ///< what is added now is the same on all processes
    double prescribed_row_ = 1.; ///< diagonal of the rows of prescribed unknowns
    const int *row_start_ = nullptr;
    const int *columns_ = nullptr;
    double *values_ = nullptr;
    double shift_ = 0; ///< of the last factorization
    bool tangent_ = true;
    EntryPlaces places_;
    std::vector<int> diagonal_places_; ///< of the own rows
    std::vector<bool> prescribed_;
    Vector residual_, magnitude_;
    Vector diagonal_; ///< of distributed rows
    struct Eliminated
    {
      DofIndex row, column;
      double value;
    };
    std::vector<Eliminated> eliminated_; ///< entries in columns of prescribed unknowns
    std::vector<Vector> border_columns_, border_rows_; ///< couplings of the border with the sparse unknowns
    std::vector<double> border_block_;
    unsigned int n_factorizations_ = 0;
  };
} // namespace deltaform
