#include "border.h"

#include <algorithm>

namespace deltaform
{
  Border::Border(const unsigned int n, const unsigned int n_sparse)
    : n_(n), n_sparse_(n_sparse), columns_(n, Vector(n_sparse)), rows_(n, Vector(n_sparse)), block_(n * n, 0.)
  {
  }


  void Border::clear()
  {
    for (unsigned int b = 0; b < n_; ++b)
      columns_[b] = rows_[b] = 0.;
    std::fill(block_.begin(), block_.end(), 0.);
  }


  void Border::add(const DofIndex row, const DofIndex column, const double value)
  {
    if (row < n_sparse_)
      columns_[column - n_sparse_][row] += value;
    else if (column < n_sparse_)
      rows_[row - n_sparse_][column] += value;
    else
      block_[(row - n_sparse_) * n_ + column - n_sparse_] += value;
  }


  void Border::stiffen(const double value)
  {
    for (unsigned int b = 0; b < n_; ++b)
      block_[b * n_ + b] += value;
  }


  void Border::multiply(const Vector &direction, Vector &result) const
  {
    for (unsigned int a = 0; a < n_; ++a)
    {
      double sum = 0.;
      for (DofIndex i = 0; i < n_sparse_; ++i)
      {
        result[i] += columns_[a][i] * direction[n_sparse_ + a];
        sum += rows_[a][i] * direction[i];
      }
      for (unsigned int b = 0; b < n_; ++b)
        sum += block(a, b) * direction[n_sparse_ + b];
      result[n_sparse_ + a] = sum;
    }
  }
} // namespace deltaform
