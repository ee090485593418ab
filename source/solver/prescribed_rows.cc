#include "prescribed_rows.h"

#include "tangent.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  PrescribedRows::PrescribedRows(const unsigned int n, const bool symmetric)
    : prescribed_(n, false), symmetric_(symmetric)
  {
  }


  void
  PrescribedRows::eliminate(double *const staged, const Tangent &tangent, const double scale, const double shift)
  {
    row_ = scale > 0 ? scale : 1.;
    eliminated_.clear();
    for (DofIndex i = tangent.first(); i < tangent.end(); ++i)
    {
      double *const diagonal = staged + tangent.diagonal_place(i);
      double *const begin = staged + tangent.row_begin(i);
      double *const end = staged + tangent.row_end(i);
      if (prescribed_[i])
      {
        std::fill(begin, end, 0.);
        *diagonal = row_;
        continue;
      }
      if (shift > 0)
        *diagonal += shift * std::max(std::abs(*diagonal), 1e-12 * scale);
      if (symmetric_)
        for (double *value = begin; value != end; ++value)
        {
          const DofIndex column = tangent.column(static_cast<int>(value - staged));
          if (!prescribed_[column] || *value == 0.)
            continue;
          eliminated_.push_back({i, column, *value});
          *value = 0.;
        }
    }
  }


  void PrescribedRows::right_side(const Vector &residual, const Vector &increments, Vector &result) const
  {
    for (DofIndex i = 0; i < result.size(); ++i)
      result[i] = prescribed_[i] ? row_ * increments[i] : -residual[i];
    for (const auto &[row, column, value] : eliminated_)
      result[row] -= value * increments[column];
  }
} // namespace deltaform
