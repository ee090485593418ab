#pragma once
// Rows of a matrix that are distributed among processes; private to the solver.
#include <deltaform/assembly/types.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <cstddef>
#include <functional>
#include <vector>

class Epetra_CrsMatrix;

namespace deltaform
{
  /**
   * A process stores the rows that it owns and, behind them, those that its cells contribute to and another process
   * owns. The pattern does not change, so that who sends how many numbers to whom is settled once: an exchange of
   * values needs no row or column numbers.
   */
  class DistributedRows
  {
  public:
    /// @param pattern in: couplings of the own cells; out: the own rows are complete
    DistributedRows(dealii::DynamicSparsityPattern &pattern, const dealii::IndexSet &owned);

    /// Where the places of values that are exchanged and of the Epetra matrix are; @p place finds that of an entry.
    void
    connect(Epetra_CrsMatrix &matrix, DofIndex first, const std::function<std::ptrdiff_t(DofIndex, DofIndex)> &place);

    /// Number of stored rows.
    unsigned int n() const
    {
      return static_cast<unsigned int>(start.size() - 1);
    }

    /// Add the rows of others to what their owners have.
    void exchange();

    /// Copy the own rows to the Epetra matrix.
    void hand_over(const double *from) const;

    /// Make the own part of a vector known to all processes.
    void share(double *vector) const;

    DofIndex first = 0, end = 0;
    std::vector<DofIndex> local; ///< place of every row of the system, if it is stored
    std::vector<int> start, columns;
    std::vector<double> values;

  private:
    /// Couplings in rows of others go to their owners. @return these rows
    std::vector<DofIndex> exchange_pattern(dealii::DynamicSparsityPattern &pattern);

    /// Storage: own rows, then those of others in the order in which they are sent.
    void store(const dealii::DynamicSparsityPattern &pattern, const std::vector<DofIndex> &foreign);

    std::vector<int> n_owned_, first_owned_; ///< by process
    std::vector<int> n_send_, n_receive_; ///< values, by process
    std::vector<unsigned int> received_rows_, received_columns_;
    std::vector<std::size_t> send_, receive_; ///< places of the values that are exchanged
    std::vector<std::size_t> handed_over_; ///< places of the values of the Epetra matrix
    double *epetra_values_ = nullptr;
  };
} // namespace deltaform
