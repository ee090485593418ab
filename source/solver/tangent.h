#pragma once
// The assembled tangent; private to the solver.
#include "border.h"
#include "distributed_rows.h"
#include "low_rank_update.h"

#include <deltaform/solver/entry_places.h>

#include <functional>
#include <memory>
#include <vector>

class Epetra_CrsMatrix;

namespace deltaform
{
  /// What is added to a tangent behind its constant part, and how it is taken back to the last bit.
  struct TangentUpdate
  {
    /// An entry as it was before something was added to it.
    struct Before
    {
      double *place;
      double value;
    };

    std::vector<Before> before;
    std::vector<UpdateEntry> entries;
    std::vector<DofIndex> bordered; ///< unknowns that the border couples with
  };

  /// What was added to a tangent up to some moment of a pass.
  struct TangentCopy
  {
    std::vector<double> values;
    Border border;
  };

  /**
   * The tangent [K B; C D] of a Newton iteration: K, of the sparse unknowns, in rows of fixed pattern; the border, of a
   * few unknowns behind them, in full columns B, rows C and the block D. This process has all rows of K, or with
   * several processes the consecutive ones that it owns; B, C and D are on all.
   */
  class Tangent
  {
  public:
    /// @param pattern couplings of the sparse unknowns; out: complete in the own rows @param owned the own rows
    Tangent(dealii::DynamicSparsityPattern &pattern, unsigned int n_border, const dealii::IndexSet &owned);

    /// The matrix that a solver works on, with the same pattern. All rows here: it is the storage.
    void connect(Epetra_CrsMatrix &matrix);

    unsigned int n_sparse() const
    {
      return n_sparse_;
    }

    unsigned int n_border() const
    {
      return border_.n();
    }

    /// The own rows: [first, end).
    DofIndex first() const
    {
      return first_;
    }

    DofIndex end() const
    {
      return end_;
    }

    bool owns(const DofIndex row) const
    {
      return !rows_ || (row >= first_ && row < end_);
    }

    /// Where rows are distributed; null: all are here.
    const DistributedRows *distributed() const
    {
      return rows_.get();
    }

    /// Keep the values of K in an array of their own, so that what a solver holds is another matrix.
    void keep_apart();

    /// A pass begins: everything is zero, or K what it was before @p update, which is empty from then on.
    void clear(TangentUpdate *update);

    /**
     * Add an n x n block, row-major. @param common it is the same on all processes, and counts once; else each adds its
     * own @param update notes it, if there is one
     */
    void add(const DofIndex *dofs, unsigned int n, const double *matrix, bool common, TangentUpdate *update);

    /// What this pass has added so far, where all rows are here.
    TangentCopy copy() const;

    /// Go on with the pass from there.
    void go_back(const TangentCopy &copy);

    /// Add @p factor scale^2 to the diagonal of K.
    void add_to_diagonal(double factor, const std::vector<double> &scale, TangentUpdate *update);

    /// Rows of K that others have contributed to go to their owners. Collective.
    void sum_over_ranks();

    /// Diagonal entry of K; 0 for unknowns of the border.
    double diagonal(DofIndex dof) const;

    /// Of all own rows of K where they are distributed: what diagonal() goes by.
    Vector &distributed_diagonal()
    {
      return diagonal_;
    }

    /// Largest entry on the diagonal of K, without unknowns that are @p prescribed.
    double largest_diagonal(const std::vector<bool> &prescribed) const;

    /// Entries K(dofs_i, dofs_j), row-major; on all processes.
    void block(const DofIndex *dofs, unsigned int n, double *result) const;

    /// The first entries of @p result = K @p direction; on all processes.
    void multiply(const Vector &direction, Vector &result) const;

    /// Visit all entries, border included; not with distributed rows.
    void for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const;

    /// An own row of K among its values: [row_begin, row_begin + 1) of the next one.
    int row_begin(const DofIndex row) const
    {
      return row_start_[row - first_];
    }

    int row_end(const DofIndex row) const
    {
      return row_start_[row - first_ + 1];
    }

    DofIndex column(const int place) const
    {
      return columns_[place];
    }

    int diagonal_place(const DofIndex own_row) const
    {
      return diagonal_places_[own_row - first_];
    }

    const double *values() const
    {
      return values_;
    }

    /**
     * The array in which the values of a matrix for the solver are prepared, a copy of K's; K's own if it is not kept
     * apart.
     */
    double *stage();

    /// Give the staged values to the solver's matrix.
    void hand_over(const double *staged) const;

    /// Make the own part of a vector known to all processes.
    void share(Vector &vector) const;

    const Border &border() const
    {
      return border_;
    }

    /// Add @p value to the diagonal of D.
    void stiffen_border(const double value)
    {
      border_.stiffen(value);
    }

  private:
    /// Place of an entry among the values, EntryPlaces::nowhere if it is not stored.
    int place(DofIndex row, DofIndex column) const;

    /// The same for an entry that must be there.
    int stored(DofIndex row, DofIndex column) const;

    void note(TangentUpdate &update, DofIndex row, DofIndex column, double value) const;

    /// Number of stored values.
    int n_values() const;

    unsigned int n_sparse_;
    DofIndex first_ = 0, end_;
    std::unique_ptr<DistributedRows> rows_; ///< null if all rows are here
    const int *row_start_ = nullptr;
    const int *columns_ = nullptr;
    double *values_ = nullptr;
    double *solver_values_ = nullptr; ///< where all rows are here
    bool apart_ = false;
    std::vector<double> storage_; ///< kept apart: of the values, or with distributed rows of what is staged
    EntryPlaces places_;
    std::vector<int> diagonal_places_; ///< of the own rows: it is read in every iteration
    Vector diagonal_; ///< of distributed rows
    Border border_;
  };
} // namespace deltaform
