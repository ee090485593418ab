#include <deltaform/solver/system.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Eigen/Dense>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  /// The library objects, kept for the whole run.
  struct System::Trilinos
  {
    Trilinos(const dealii::DynamicSparsityPattern &pattern, const std::string &solver)
    {
      matrix.reinit(pattern);
      // The wrapper only hands out a const reference to the matrix that it owns.
      crs        = &const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      solution   = std::make_unique<Epetra_Vector>(crs->DomainMap());
      right_side = std::make_unique<Epetra_Vector>(crs->RangeMap());
      problem    = std::make_unique<Epetra_LinearProblem>(crs, solution.get(), right_side.get());
      factorization =
        std::unique_ptr<Amesos_BaseSolver>(Amesos().Create(solver == "mumps" ? "Mumps" : "Klu", *problem));
      AssertThrow(factorization, dealii::ExcMessage("This Trilinos has no Amesos solver '" + solver + "'."));
      Teuchos::ParameterList list;
      list.set("PrintTiming", false);
      list.set("PrintStatus", false);
      factorization->SetParameters(list);
    }

    dealii::TrilinosWrappers::SparseMatrix matrix;
    Epetra_CrsMatrix *crs = nullptr;
    std::unique_ptr<Epetra_Vector> solution, right_side;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver> factorization;
    bool analysed = false;
  };


  System::System(const dealii::DynamicSparsityPattern &pattern, const unsigned int n_border, const std::string &solver)
    : n_sparse_(pattern.n_rows()), n_border_(n_border), trilinos_(std::make_unique<Trilinos>(pattern, solver)),
      prescribed_(n_sparse_ + n_border, false), residual_(n_sparse_ + n_border), magnitude_(n_sparse_ + n_border),
      border_columns_(n_border, Vector(n_sparse_)), border_rows_(n_border, Vector(n_sparse_)),
      border_block_(n_border * n_border, 0.)
  {
    int *start = nullptr, *columns = nullptr;
    const int error = trilinos_->crs->ExtractCrsDataPointers(start, columns, values_);
    AssertThrow(error == 0, dealii::ExcMessage("The matrix has no contiguous storage."));
    row_start_ = start;
    columns_   = columns;
  }


  System::~System()                             = default;
  System::System(System &&) noexcept            = default;
  System &System::operator=(System &&) noexcept = default;


  unsigned int System::size() const
  {
    return n_sparse_ + n_border_;
  }


  void System::clear(const bool tangent)
  {
    tangent_   = tangent;
    residual_  = 0.;
    magnitude_ = 0.;
    if (!tangent)
      return;
    std::fill(values_, values_ + row_start_[n_sparse_], 0.);
    for (unsigned int b = 0; b < n_border_; ++b)
      border_columns_[b] = border_rows_[b] = 0.;
    std::fill(border_block_.begin(), border_block_.end(), 0.);
  }


  bool System::wants_tangent() const
  {
    return tangent_;
  }


  double *System::entry(const DofIndex row, const DofIndex column) const
  {
    const int *const first = columns_ + row_start_[row];
    const int *const last  = columns_ + row_start_[row + 1];
    const int *const place = std::lower_bound(first, last, static_cast<int>(column));
    Assert(place != last && *place == static_cast<int>(column),
           dealii::ExcMessage("This coupling is not in the pattern."));
    return values_ + (place - columns_);
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
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double value = matrix[i * n + j];
        if (dofs[i] < n_sparse_ && dofs[j] < n_sparse_)
        {
          if (value != 0.)
            *entry(dofs[i], dofs[j]) += value;
        }
        else if (dofs[i] < n_sparse_)
          border_columns_[dofs[j] - n_sparse_][dofs[i]] += value;
        else if (dofs[j] < n_sparse_)
          border_rows_[dofs[i] - n_sparse_][dofs[j]] += value;
        else
          border_block_[(dofs[i] - n_sparse_) * n_border_ + dofs[j] - n_sparse_] += value;
      }
  }


  void System::block(const DofIndex *dofs, const unsigned int n, double *result) const
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result[i * n + j] = *entry(dofs[i], dofs[j]);
  }


  void System::multiply(const Vector &direction, Vector &result) const
  {
    for (unsigned int i = 0; i < n_sparse_; ++i)
    {
      double sum = 0.;
      for (int k = row_start_[i]; k < row_start_[i + 1]; ++k)
        sum += values_[k] * direction[columns_[k]];
      result[i] = sum;
    }
  }


  void System::set_prescribed(const std::vector<bool> &prescribed)
  {
    prescribed_ = prescribed;
  }


  void System::for_each_entry(const std::function<void(DofIndex, DofIndex, double)> &action) const
  {
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
    for (unsigned int i = 0; i < n_sparse_; ++i)
      *entry(i, i) += factor * scale[i] * scale[i];
  }


  double System::diagonal(const DofIndex dof) const
  {
    return dof < n_sparse_ ? *entry(dof, dof) : 0.;
  }


  double System::largest_diagonal() const
  {
    double largest = 0.;
    for (unsigned int i = 0; i < n_sparse_; ++i)
      if (!prescribed_[i])
        largest = std::max(largest, std::abs(*entry(i, i)));
    return largest;
  }


  bool System::factorize(const double shift)
  {
    const double scale = largest_diagonal();
    for (unsigned int i = 0; i < n_sparse_; ++i)
    {
      double *const diagonal = entry(i, i);
      if (prescribed_[i])
      {
        std::fill(values_ + row_start_[i], values_ + row_start_[i + 1], 0.);
        *diagonal = scale > 0 ? scale : 1.;
      }
      else if (shift > 0)
        *diagonal += shift * std::max(std::abs(*diagonal), 1e-12 * scale);
    }
    shift_ = shift;
    ++n_factorizations_;
    if (!trilinos_->analysed && trilinos_->factorization->SymbolicFactorization() != 0)
      return false;
    trilinos_->analysed = true;
    return trilinos_->factorization->NumericFactorization() == 0;
  }


  bool System::solve_sparse(const Vector &right_side, Vector &solution)
  {
    std::copy(right_side.begin(), right_side.begin() + n_sparse_, trilinos_->right_side->Values());
    if (trilinos_->factorization->Solve() != 0)
      return false;
    const double *const values = trilinos_->solution->Values();
    std::copy(values, values + n_sparse_, solution.begin());
    for (unsigned int i = 0; i < n_sparse_; ++i)
      if (!std::isfinite(values[i]))
        return false;
    return true;
  }


  bool System::solve(const Vector &increments, Vector &d)
  {
    Vector right_side(n_sparse_);
    for (unsigned int i = 0; i < n_sparse_; ++i)
      right_side[i] = prescribed_[i] ? *entry(i, i) * increments[i] : -residual_[i];
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
        load[a]     = increments[n_sparse_ + a];
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
