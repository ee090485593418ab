#include "tangent.h"

#include <deltaform/process/ranks.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  Tangent::Tangent(dealii::DynamicSparsityPattern &pattern,
                   const unsigned int n_border,
                   const dealii::IndexSet &owned)
    : n_sparse_(pattern.n_rows()), end_(n_sparse_), border_(n_border, n_sparse_)
  {
    // A process may own all rows by chance: what counts is whether any one does not.
    if (ranks::max(owned.n_elements() != n_sparse_ ? 1. : 0.) == 0)
      return;
    rows_ = std::make_unique<DistributedRows>(pattern, owned);
    first_ = rows_->first;
    end_ = rows_->end;
    row_start_ = rows_->start.data();
    columns_ = rows_->columns.data();
    values_ = rows_->values.data();
    diagonal_.reinit(n_sparse_);
  }


  void Tangent::connect(Epetra_CrsMatrix &matrix)
  {
    int *start = nullptr, *columns = nullptr;
    double *values = nullptr;
    const int error = matrix.ExtractCrsDataPointers(start, columns, values);
    AssertThrow(error == 0, dealii::ExcMessage("The matrix has no contiguous storage."));
    if (rows_)
      rows_->connect(matrix, first_, [&](const DofIndex i, const DofIndex j) { return stored(i, j); });
    else
    {
      row_start_ = start;
      columns_ = columns;
      values_ = solver_values_ = values;
    }
    diagonal_places_.resize(end_ - first_);
    for (DofIndex i = first_; i < end_; ++i)
      diagonal_places_[i - first_] = stored(i, i);
  }


  int Tangent::n_values() const
  {
    return row_start_[rows_ ? rows_->n() : n_sparse_];
  }


  void Tangent::keep_apart()
  {
    apart_ = true;
    if (rows_)
      return;
    storage_.assign(static_cast<std::size_t>(n_values()), 0.);
    values_ = storage_.data();
  }


  void Tangent::clear(TangentUpdate *const update)
  {
    places_.restart();
    if (update != nullptr)
    {
      for (auto old = update->before.rbegin(); old != update->before.rend(); ++old)
        *old->place = old->value;
      update->before.clear();
      update->entries.clear();
      update->bordered.clear();
    }
    else
      std::fill(values_, values_ + n_values(), 0.);
    border_.clear();
  }


  TangentCopy Tangent::copy() const
  {
    return {std::vector<double>(values_, values_ + n_values()), border_};
  }


  void Tangent::go_back(const TangentCopy &copy)
  {
    std::copy(copy.values.begin(), copy.values.end(), values_);
    border_ = copy.border;
  }


  int Tangent::place(const DofIndex row, const DofIndex column) const
  {
    if (row >= n_sparse_ || column >= n_sparse_)
      return EntryPlaces::nowhere;
    const DofIndex local = rows_ ? rows_->local[row] : row;
    const int *const first = columns_ + row_start_[local];
    const int *const last = columns_ + row_start_[local + 1];
    const int *const found = std::find(first, last, static_cast<int>(column)); // rows are short
    return found != last ? static_cast<int>(found - columns_) : EntryPlaces::nowhere;
  }


  int Tangent::stored(const DofIndex row, const DofIndex column) const
  {
    const int where = place(row, column);
    Assert(where != EntryPlaces::nowhere, dealii::ExcMessage("This coupling is not in the pattern."));
    return where;
  }


  void Tangent::note(TangentUpdate &update, const DofIndex row, const DofIndex column, const double value) const
  {
    if (row >= n_sparse_ || column >= n_sparse_)
    {
      for (const auto dof : {row, column})
        if (dof < n_sparse_)
          update.bordered.push_back(dof);
      return;
    }
    update.entries.push_back({row, column, value});
    if (owns(row))
    {
      double *const place = values_ + stored(row, column);
      update.before.push_back({place, *place});
    }
  }


  void Tangent::add(const DofIndex *dofs,
                    const unsigned int n,
                    const double *matrix,
                    const bool common,
                    TangentUpdate *const update)
  {
    const int *const places =
      places_.next(dofs,
                   n,
                   common ? 1 : 0,
                   [&](const DofIndex row, const DofIndex column) {
                     return common && row < n_sparse_ && !owns(row) ? EntryPlaces::nowhere : place(row, column);
                   });
    if (update != nullptr)
      for (unsigned int k = 0; k < n * n; ++k)
        if (matrix[k] != 0.)
          note(*update, dofs[k / n], dofs[k % n], matrix[k]);
    for (unsigned int k = 0; k < n * n; ++k)
    {
      const double value = matrix[k];
      if (const int where = places[k]; where != EntryPlaces::nowhere)
        values_[where] += value;
      else if (const DofIndex row = dofs[k / n], column = dofs[k % n];
               value != 0. && (row >= n_sparse_ || column >= n_sparse_))
        border_.add(row, column, value);
      else
        Assert(value == 0. || (common && !owns(row)), dealii::ExcMessage("This coupling is not in the pattern."));
    }
    if (rows_ && common)
      for (unsigned int i = 0; i < n; ++i)
        if (dofs[i] < n_sparse_)
          diagonal_[dofs[i]] += matrix[i * n + i];
  }


  void Tangent::add_to_diagonal(const double factor, const std::vector<double> &scale, TangentUpdate *const update)
  {
    for (DofIndex i = 0; i < n_sparse_; ++i)
    {
      const double value = factor * scale[i] * scale[i];
      if (update != nullptr)
        note(*update, i, i, value);
      if (owns(i))
        values_[diagonal_places_[i - first_]] += value;
      if (rows_)
        diagonal_[i] += value;
    }
  }


  void Tangent::sum_over_ranks()
  {
    if (!rows_)
      return;
    rows_->exchange();
    diagonal_ = 0.;
    for (DofIndex i = first_; i < end_; ++i)
      diagonal_[i] = values_[diagonal_places_[i - first_]];
    ranks::sum(diagonal_.begin(), diagonal_.size());
  }


  double Tangent::diagonal(const DofIndex dof) const
  {
    return dof >= n_sparse_ ? 0. : (rows_ ? diagonal_[dof] : values_[diagonal_places_[dof]]);
  }


  double Tangent::largest_diagonal(const std::vector<bool> &prescribed) const
  {
    double largest = 0.;
    for (unsigned int i = 0; i < n_sparse_; ++i)
      if (!prescribed[i])
        largest = std::max(largest, std::abs(diagonal(i)));
    return largest;
  }


  void Tangent::block(const DofIndex *dofs, const unsigned int n, double *result) const
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result[i * n + j] = owns(dofs[i]) ? values_[stored(dofs[i], dofs[j])] : 0.;
    if (rows_)
      ranks::sum(result, std::size_t(n) * n);
  }


  void Tangent::multiply(const Vector &direction, Vector &result) const
  {
    if (rows_)
      std::fill(result.begin(), result.begin() + n_sparse_, 0.);
    for (DofIndex i = first_; i < end_; ++i)
    {
      const DofIndex local = i - first_;
      double sum = 0.;
      for (int k = row_start_[local]; k < row_start_[local + 1]; ++k)
        sum += values_[k] * direction[columns_[k]];
      result[i] = sum;
    }
    if (rows_)
      ranks::sum(result.begin(), n_sparse_);
  }


  void Tangent::for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const
  {
    Assert(!rows_, dealii::ExcMessage("No process has all entries."));
    for (unsigned int i = 0; i < n_sparse_; ++i)
      for (int k = row_start_[i]; k < row_start_[i + 1]; ++k)
        action(i, columns_[k], values_[k]);
    for (unsigned int a = 0; a < n_border(); ++a)
    {
      for (unsigned int i = 0; i < n_sparse_; ++i)
      {
        if (border_.columns()[a][i] != 0.)
          action(i, n_sparse_ + a, border_.columns()[a][i]);
        if (border_.rows()[a][i] != 0.)
          action(n_sparse_ + a, i, border_.rows()[a][i]);
      }
      for (unsigned int b = 0; b < n_border(); ++b)
        action(n_sparse_ + a, n_sparse_ + b, border_.block(a, b));
    }
  }


  double *Tangent::stage()
  {
    if (!apart_)
      return values_;
    if (!rows_)
      return std::copy(storage_.begin(), storage_.end(), solver_values_) - storage_.size();
    storage_.assign(values_, values_ + n_values());
    return storage_.data();
  }


  void Tangent::hand_over(const double *const staged) const
  {
    if (rows_)
      rows_->hand_over(staged);
  }


  void Tangent::share(Vector &vector) const
  {
    if (rows_)
      rows_->share(vector.begin());
  }
} // namespace deltaform
