#include "distributed_rows.h"

#include <deltaform/process/ranks.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <numeric>

namespace deltaform
{
  namespace
  {
    std::vector<int> starts(const std::vector<int> &sizes)
    {
      std::vector<int> result(sizes.size(), 0);
      std::partial_sum(sizes.begin(), sizes.end() - 1, result.begin() + 1);
      return result;
    }
  } // namespace


  DistributedRows::DistributedRows(dealii::DynamicSparsityPattern &pattern, const dealii::IndexSet &owned)
  {
    n_owned_ = ranks::gather(std::vector<int>{static_cast<int>(owned.n_elements())});
    first_owned_ = starts(n_owned_);
    first = static_cast<DofIndex>(first_owned_[ranks::mine()]);
    end = first + owned.n_elements();
    AssertThrow(owned.n_elements() == 0 || (owned.is_contiguous() && owned.nth_index_in_set(0) == first),
                dealii::ExcMessage("Own rows are not consecutive."));
    store(pattern, exchange_pattern(pattern));
  }


  std::vector<DofIndex> DistributedRows::exchange_pattern(dealii::DynamicSparsityPattern &pattern)
  {
    const unsigned int n_rows = pattern.n_rows(), n_ranks = ranks::count();
    std::vector<DofIndex> foreign;
    std::vector<std::vector<unsigned int>> rows(n_ranks), cols(n_ranks);
    for (DofIndex i = 0; i < n_rows; ++i)
    {
      if ((i >= first && i < end) || pattern.row_length(i) == 0)
        continue;
      foreign.push_back(i);
      // The last process whose rows begin at or before this one: those without rows begin where the next one does.
      const auto owner =
        std::upper_bound(first_owned_.begin(), first_owned_.end(), static_cast<int>(i)) - first_owned_.begin() - 1;
      for (auto column = pattern.begin(i); column != pattern.end(i); ++column)
      {
        rows[owner].push_back(i);
        cols[owner].push_back(column->column());
      }
    }
    n_send_.resize(n_ranks);
    n_receive_.resize(n_ranks);
    std::vector<unsigned int> sent_rows, sent_columns;
    for (unsigned int r = 0; r < n_ranks; ++r)
    {
      n_send_[r] = static_cast<int>(rows[r].size());
      sent_rows.insert(sent_rows.end(), rows[r].begin(), rows[r].end());
      sent_columns.insert(sent_columns.end(), cols[r].begin(), cols[r].end());
    }
    MPI_Alltoall(n_send_.data(), 1, MPI_INT, n_receive_.data(), 1, MPI_INT, ranks::communicator());
    const auto n_received = std::accumulate(n_receive_.begin(), n_receive_.end(), 0);
    received_rows_.resize(n_received);
    received_columns_.resize(n_received);
    const auto to = starts(n_send_), from = starts(n_receive_);
    for (const auto &[out, in] : {std::pair(&sent_rows, &received_rows_), std::pair(&sent_columns, &received_columns_)})
      MPI_Alltoallv(out->data(),
                    n_send_.data(),
                    to.data(),
                    MPI_UNSIGNED,
                    in->data(),
                    n_receive_.data(),
                    from.data(),
                    MPI_UNSIGNED,
                    ranks::communicator());
    for (int k = 0; k < n_received; ++k)
      pattern.add(received_rows_[k], received_columns_[k]);
    return foreign;
  }


  void DistributedRows::store(const dealii::DynamicSparsityPattern &pattern, const std::vector<DofIndex> &foreign)
  {
    local.assign(pattern.n_rows(), dealii::numbers::invalid_dof_index);
    start.push_back(0);
    const auto store_row = [&](const DofIndex i) {
      local[i] = start.size() - 1;
      for (auto column = pattern.begin(i); column != pattern.end(i); ++column)
        columns.push_back(static_cast<int>(column->column()));
      start.push_back(static_cast<int>(columns.size()));
    };
    for (DofIndex i = first; i < end; ++i)
      store_row(i);
    const std::size_t n_own = columns.size();
    for (const auto i : foreign)
      store_row(i);
    send_.resize(columns.size() - n_own);
    std::iota(send_.begin(), send_.end(), n_own);
    values.assign(columns.size(), 0.);
  }


  void DistributedRows::connect(Epetra_CrsMatrix &matrix,
                                const DofIndex first_row,
                                const std::function<std::ptrdiff_t(DofIndex, DofIndex)> &place)
  {
    for (std::size_t k = 0; k < received_rows_.size(); ++k)
      receive_.push_back(static_cast<std::size_t>(place(received_rows_[k], received_columns_[k])));
    received_rows_.clear();
    received_columns_.clear();
    int *row_start = nullptr, *column = nullptr;
    const int status = matrix.ExtractCrsDataPointers(row_start, column, epetra_values_);
    AssertThrow(status == 0 && row_start != nullptr && column != nullptr,
                dealii::ExcMessage("the matrix is not stored row by row"));
    for (int i = 0; i < matrix.NumMyRows(); ++i)
      for (int k = row_start[i]; k < row_start[i + 1]; ++k)
        handed_over_.push_back(static_cast<std::size_t>(
          place(first_row + static_cast<DofIndex>(i), static_cast<DofIndex>(matrix.GCID(column[k])))));
  }


  void DistributedRows::exchange()
  {
    std::vector<double> out(send_.size()), in(receive_.size());
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = values[send_[k]];
    const auto to = starts(n_send_), from = starts(n_receive_);
    MPI_Alltoallv(out.data(),
                  n_send_.data(),
                  to.data(),
                  MPI_DOUBLE,
                  in.data(),
                  n_receive_.data(),
                  from.data(),
                  MPI_DOUBLE,
                  ranks::communicator());
    for (std::size_t k = 0; k < in.size(); ++k)
      values[receive_[k]] += in[k];
  }


  void DistributedRows::hand_over(const double *const from) const
  {
    for (std::size_t k = 0; k < handed_over_.size(); ++k)
      epetra_values_[k] = from[handed_over_[k]];
  }


  void DistributedRows::share(double *const vector) const
  {
    MPI_Allgatherv(MPI_IN_PLACE,
                   0,
                   MPI_DATATYPE_NULL,
                   vector,
                   n_owned_.data(),
                   first_owned_.data(),
                   MPI_DOUBLE,
                   ranks::communicator());
  }
} // namespace deltaform
