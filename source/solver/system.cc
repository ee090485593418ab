#include "system_constant.h"
#include "system_rows.h"

#include <deltaform/base/ranks.h>

#include <Eigen/Dense>
#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace deltaform
{
  System::System(dealii::DynamicSparsityPattern &&pattern,
                 const unsigned int n_border,
                 const LinearSolverSettings &solver,
                 const dealii::IndexSet &owned)
    : n_sparse_(pattern.n_rows()), n_border_(n_border), end_(n_sparse_), symmetric_elimination_(solver.iterative()),
      prescribed_(n_sparse_ + n_border, false), residual_(n_sparse_ + n_border), magnitude_(n_sparse_ + n_border),
      border_columns_(n_border, Vector(n_sparse_)), border_rows_(n_border, Vector(n_sparse_)),
      border_block_(n_border * n_border, 0.)
  {
    // A process may own all rows by chance: what counts is whether any one does not.
    if (ranks::max(owned.n_elements() != n_sparse_ ? 1. : 0.) > 0)
      distribute(pattern, owned);
    solver_ = rows_ ? LinearSolver::distributed(solver, pattern, first_, end_) : LinearSolver::local(solver, pattern);
    auto &matrix = solver_->matrix();
    int *start = nullptr, *columns = nullptr;
    double *values = nullptr;
    const int error = matrix.ExtractCrsDataPointers(start, columns, values);
    AssertThrow(error == 0, dealii::ExcMessage("The matrix has no contiguous storage."));
    if (rows_)
    {
      rows_->connect(matrix, first_, [&](const DofIndex i, const DofIndex j) { return entry(i, j) - values_; });
      find_diagonal();
      return;
    }
    row_start_ = start;
    columns_ = columns;
    values_ = values;
    find_diagonal();
  }


  System::System(dealii::DynamicSparsityPattern &&pattern, const unsigned int n_border, const std::string &solver)
    : System(std::move(pattern), n_border, LinearSolverSettings(solver), dealii::complete_index_set(pattern.n_rows()))
  {
  }


  System::~System() = default;
  System::System(System &&) noexcept = default;
  System &System::operator=(System &&) noexcept = default;


  unsigned int System::size() const
  {
    return n_sparse_ + n_border_;
  }


  void System::clear(const bool tangent)
  {
    tangent_ = tangent;
    common_ = !rows_;
    residual_ = 0.;
    magnitude_ = 0.;
    if (constant_)
      constant_->complete = false;
    if (!tangent)
      return;
    places_.restart();
    if (constant_ && constant_->kept)
      restore_constant();
    else
      std::fill(values_, values_ + row_start_[rows_ ? rows_->n() : n_sparse_], 0.);
    for (unsigned int b = 0; b < n_border_; ++b)
      border_columns_[b] = border_rows_[b] = 0.;
    std::fill(border_block_.begin(), border_block_.end(), 0.);
  }


  bool System::wants_tangent() const
  {
    return tangent_ && !(constant_ && constant_->kept && !constant_->complete);
  }


  int System::place(const DofIndex row, const DofIndex column) const
  {
    if (row >= n_sparse_ || column >= n_sparse_)
      return EntryPlaces::nowhere;
    const DofIndex local = rows_ ? rows_->local[row] : row;
    const int *const first = columns_ + row_start_[local];
    const int *const last = columns_ + row_start_[local + 1];
    const int *const found = std::lower_bound(first, last, static_cast<int>(column));
    return found != last && *found == static_cast<int>(column) ? static_cast<int>(found - columns_)
                                                               : EntryPlaces::nowhere;
  }


  double *System::entry(const DofIndex row, const DofIndex column) const
  {
    const int where = place(row, column);
    Assert(where != EntryPlaces::nowhere, dealii::ExcMessage("This coupling is not in the pattern."));
    return values_ + where;
  }


  void System::find_diagonal()
  {
    diagonal_places_.resize(end_ - first_);
    for (DofIndex i = first_; i < end_; ++i)
      diagonal_places_[i - first_] = static_cast<int>(entry(i, i) - values_);
  }


  void System::add(const DofIndex *dofs, const unsigned int n, const double *matrix, const double *vector)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      residual_[dofs[i]] += vector[i];
      magnitude_[dofs[i]] += std::abs(vector[i]);
    }
    if (matrix == nullptr || !tangent_)
      return;
    const int *const places =
      places_.next(dofs,
                   n,
                   common_ ? 1 : 0,
                   [&](const DofIndex row, const DofIndex column) {
                     return common_ && row < n_sparse_ && !owns(row) ? EntryPlaces::nowhere : place(row, column);
                   });
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double value = matrix[i * n + j];
        if (constant_ && value != 0.)
          constant_->note(*this, dofs[i], dofs[j], value);
        if (const int where = places[i * n + j]; where != EntryPlaces::nowhere)
          values_[where] += value;
        else if (value != 0.)
          add_elsewhere(dofs[i], dofs[j], value);
      }
    if (rows_ && common_)
      for (unsigned int i = 0; i < n; ++i)
        if (dofs[i] < n_sparse_)
          diagonal_[dofs[i]] += matrix[i * n + i];
  }


  void System::add_elsewhere(const DofIndex row, const DofIndex column, const double value)
  {
    if (row < n_sparse_ && column < n_sparse_)
    {
      Assert(common_ && !owns(row), dealii::ExcMessage("This coupling is not in the pattern."));
    }
    else if (row < n_sparse_)
      border_columns_[column - n_sparse_][row] += value;
    else if (column < n_sparse_)
      border_rows_[row - n_sparse_][column] += value;
    else
      border_block_[(row - n_sparse_) * n_border_ + column - n_sparse_] += value;
  }


  void System::block(const DofIndex *dofs, const unsigned int n, double *result) const
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result[i * n + j] = owns(dofs[i]) ? *entry(dofs[i], dofs[j]) : 0.;
    if (rows_)
      ranks::sum(result, std::size_t(n) * n);
  }


  void System::multiply(const Vector &direction, Vector &result) const
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


  void System::set_prescribed(const std::vector<bool> &prescribed)
  {
    prescribed_ = prescribed;
  }


  void System::for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const
  {
    Assert(!rows_, dealii::ExcMessage("No process has all entries."));
    for (unsigned int i = 0; i < n_sparse_; ++i)
      for (int k = row_start_[i]; k < row_start_[i + 1]; ++k)
        action(i, columns_[k], values_[k]);
    for (unsigned int a = 0; a < n_border_; ++a)
    {
      for (unsigned int i = 0; i < n_sparse_; ++i)
      {
        if (border_columns_[a][i] != 0.)
          action(i, n_sparse_ + a, border_columns_[a][i]);
        if (border_rows_[a][i] != 0.)
          action(n_sparse_ + a, i, border_rows_[a][i]);
      }
      for (unsigned int b = 0; b < n_border_; ++b)
        action(n_sparse_ + a, n_sparse_ + b, border_block_[a * n_border_ + b]);
    }
  }


  void System::add_to_diagonal(const double factor, const std::vector<double> &scale)
  {
    for (DofIndex i = 0; i < n_sparse_; ++i)
    {
      const double value = factor * scale[i] * scale[i];
      if (constant_)
        constant_->note(*this, i, i, value);
      if (owns(i))
        values_[diagonal_places_[i - first_]] += value;
      if (rows_)
        diagonal_[i] += value;
    }
  }


  double System::diagonal(const DofIndex dof) const
  {
    return dof >= n_sparse_ ? 0. : (rows_ ? diagonal_[dof] : values_[diagonal_places_[dof]]);
  }


  double System::largest_diagonal() const
  {
    double largest = 0.;
    for (unsigned int i = 0; i < n_sparse_; ++i)
      if (!prescribed_[i])
        largest = std::max(largest, std::abs(diagonal(i)));
    return largest;
  }
} // namespace deltaform
