// Factorizing the matrix and solving with its border.
#include "system_constant.h"
#include "system_rows.h"

#include <Eigen/Dense>
#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace deltaform
{
  void System::eliminate(double *const staged, const double scale, const double shift)
  {
    prescribed_row_ = scale > 0 ? scale : 1.;
    eliminated_.clear();
    for (DofIndex i = first_; i < end_; ++i)
    {
      double *const diagonal = staged + diagonal_places_[i - first_];
      double *const begin = staged + row_start_[i - first_];
      double *const end = staged + row_start_[i - first_ + 1];
      if (prescribed_[i])
      {
        std::fill(begin, end, 0.);
        *diagonal = prescribed_row_;
        continue;
      }
      if (shift > 0)
        *diagonal += shift * std::max(std::abs(*diagonal), 1e-12 * scale);
      if (symmetric_elimination_)
        for (double *value = begin; value != end; ++value)
        {
          const DofIndex column = columns_[value - staged];
          if (!prescribed_[column] || *value == 0.)
            continue;
          eliminated_.push_back({i, column, *value});
          *value = 0.;
        }
    }
  }


  void System::forget_factors()
  {
    solver_->forget();
  }


  bool System::factorize(const double shift)
  {
    if (constant_ && shift == 0. && factorize_constant())
      return true;
    return factorize_whole(shift);
  }


  bool System::factorize_whole(const double shift)
  {
    const double scale = largest_diagonal();
    double *const staged = stage();
    eliminate(staged, scale, shift);
    // A force-driven tool that has lost the blank: it moves along its force.
    for (unsigned int b = 0; b < n_border_; ++b)
      border_block_[b * n_border_ + b] += shift * scale;
    ++n_factorizations_;
    hand_over(staged);
    return solver_->factorize();
  }


  bool System::solve_sparse(const Vector &right_side, Vector &solution)
  {
    if (!solver_->solve(right_side.begin() + first_, solution.begin() + first_))
      return false;
    if (rows_)
      rows_->share(solution.begin());
    for (unsigned int i = 0; i < n_sparse_; ++i)
      if (!std::isfinite(solution[i]))
        return false;
    return true;
  }


  void System::set_near_null_space(const std::vector<Vector> &motions)
  {
    if (constant_)
      constant_->motions = motions;
    solver_->set_near_null_space(motions, first_, end_);
  }


  std::string System::linear_failure() const
  {
    return solver_->failure();
  }


  unsigned int System::n_linear_iterations() const
  {
    return solver_->n_iterations();
  }


  void System::right_side(const Vector &increments, Vector &result) const
  {
    for (unsigned int i = 0; i < n_sparse_; ++i)
      result[i] = prescribed_[i] ? prescribed_row_ * increments[i] : -residual_[i];
    for (const auto &[row, column, value] : eliminated_)
      result[row] -= value * increments[column];
  }


  bool System::solve(const Vector &increments, Vector &d)
  {
    if (constant_ && constant_->condensed)
    {
      if (solve_condensed(increments, d))
        return true;
      // The sum is singular, or nearly: what the whole matrix makes of it is what a run without an update would see.
      if (!factorize_whole(0.))
        return false;
    }
    Vector right_side(n_sparse_);
    this->right_side(increments, right_side);
    if (!solve_sparse(right_side, d))
      return false;
    if (n_border_ == 0)
      return true;

    // (D - C K^-1 B) w = -R_w - C K^-1 (-R), then d -= K^-1 B w
    std::vector<Vector> eliminated(n_border_, Vector(n_sparse_));
    Eigen::MatrixXd schur(n_border_, n_border_);
    Eigen::VectorXd load(n_border_);
    for (unsigned int b = 0; b < n_border_; ++b)
    {
      for (unsigned int i = 0; i < n_sparse_; ++i)
        right_side[i] = prescribed_[i] ? 0. : border_columns_[b][i];
      if (!solve_sparse(right_side, eliminated[b]))
        return false;
    }
    for (unsigned int a = 0; a < n_border_; ++a)
    {
      load[a] = -residual_[n_sparse_ + a];
      for (unsigned int i = 0; i < n_sparse_; ++i)
        load[a] -= border_rows_[a][i] * d[i];
      for (unsigned int b = 0; b < n_border_; ++b)
        schur(a, b) = border_block_[a * n_border_ + b] - border_rows_[a] * eliminated[b];
      if (prescribed_[n_sparse_ + a])
      {
        schur.row(a).setZero();
        schur(a, a) = 1.;
        load[a] = increments[n_sparse_ + a];
      }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(schur);
    if (!lu.isInvertible())
      return false;
    const Eigen::VectorXd w = lu.solve(load);
    for (unsigned int b = 0; b < n_border_; ++b)
    {
      if (!std::isfinite(w[b]))
        return false;
      d[n_sparse_ + b] = w[b];
      for (unsigned int i = 0; i < n_sparse_; ++i)
        d[i] -= eliminated[b][i] * w[b];
    }
    return true;
  }
} // namespace deltaform
