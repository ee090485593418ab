#pragma once
// The border of a bordered matrix; private to the solver.
#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /// B, C and D of the matrix [K B; C D]: the few unknowns behind the sparse ones, in full columns, rows and a block.
  class Border
  {
  public:
    Border(unsigned int n, unsigned int n_sparse);

    void clear();

    /// Add to the entry (@p row, @p column), one of which or both belong to the border.
    void add(DofIndex row, DofIndex column, double value);

    /// Add @p value to the diagonal of D.
    void stiffen(double value);

    /// Add B times the last entries of @p direction to the first of @p result; its last ones become [C D] @p direction.
    void multiply(const Vector &direction, Vector &result) const;

    unsigned int n() const
    {
      return n_;
    }

    const std::vector<Vector> &columns() const
    {
      return columns_;
    }

    const std::vector<Vector> &rows() const
    {
      return rows_;
    }

    double block(const unsigned int a, const unsigned int b) const
    {
      return block_[a * n_ + b];
    }

  private:
    unsigned int n_, n_sparse_;
    std::vector<Vector> columns_, rows_;
    std::vector<double> block_;
  };
} // namespace deltaform
