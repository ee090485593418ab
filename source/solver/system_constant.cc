// A tangent with a constant part: derivation in doc/theory/solver.md, "A constant part".
#include "system_constant.h"

#include "system_rows.h"

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  void System::keep_constant_part(std::vector<DofIndex> candidates, const std::size_t largest_rank)
  {
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    constant_ = std::make_unique<Constant>(std::move(candidates), largest_rank);
    if (rows_)
      return;
    constant_->storage.assign(static_cast<std::size_t>(row_start_[n_sparse_]), 0.);
    values_ = constant_->storage.data();
  }


  void System::Constant::note(const System &system, const DofIndex row, const DofIndex column, const double value)
  {
    if (!kept)
      return;
    if (row >= system.n_sparse_ || column >= system.n_sparse_)
    {
      for (const auto dof : {row, column})
        if (dof < system.n_sparse_)
          bordered.push_back(dof);
      return;
    }
    entries.push_back({row, column, value});
    if (system.owns(row))
    {
      double *const place = system.entry(row, column);
      before.push_back({place, *place});
    }
  }


  void System::restore_constant()
  {
    auto &constant = *constant_;
    for (auto old = constant.before.rbegin(); old != constant.before.rend(); ++old)
      *old->place = old->value;
    constant.before.clear();
    constant.entries.clear();
    constant.bordered.clear();
    if (rows_)
      diagonal_ = constant.diagonal;
  }


  double *System::stage()
  {
    if (!constant_)
      return values_;
    constant_->prepared = constant_->condensed = false;
    if (!rows_)
    {
      auto &matrix = solver_->matrix();
      std::copy(constant_->storage.begin(), constant_->storage.end(), matrix[0]);
      return matrix[0];
    }
    constant_->storage.assign(values_, values_ + row_start_[rows_->n()]);
    return constant_->storage.data();
  }


  void System::hand_over(const double *const staged)
  {
    if (rows_)
      rows_->hand_over(staged);
  }


  namespace
  {
    /**
     * Unknowns to hold so that no motion is free: as many of @p candidates as there are combinations of @p motions that
     * leave all prescribed unknowns where they are, chosen for their independence. Empty if the candidates do not do.
     */
    std::vector<DofIndex> hold(const std::vector<Vector> &motions,
                               const std::vector<DofIndex> &candidates,
                               const std::vector<bool> &prescribed,
                               Eigen::Index &n_free)
    {
      std::vector<DofIndex> result;
      if (motions.empty())
        return result;
      const auto n_motions = static_cast<Eigen::Index>(motions.size());
      Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n_motions, n_motions), held = all;
      for (DofIndex i = 0; i < motions[0].size(); ++i)
        for (Eigen::Index a = 0; a < n_motions; ++a)
          for (Eigen::Index b = 0; b < n_motions; ++b)
          {
            const double product = motions[a][i] * motions[b][i];
            all(a, b) += product;
            held(a, b) += prescribed[i] ? product : 0.;
          }
      // A motion whose prescribed part is less than 1e-5 of it is free.
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(held, all);
      n_free = (eigen.eigenvalues().array() < 1e-10).count();
      Eigen::MatrixXd at(n_free, static_cast<Eigen::Index>(candidates.size()));
      for (Eigen::Index i = 0; i < at.cols(); ++i)
      {
        const DofIndex dof = candidates[i];
        for (Eigen::Index f = 0; f < n_free; ++f)
        {
          at(f, i) = 0.;
          for (Eigen::Index a = 0; a < n_motions; ++a)
            at(f, i) += prescribed[dof] ? 0. : eigen.eigenvectors()(a, f) * motions[a][dof];
        }
      }
      if (n_free == 0)
        return result;
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(at);
      for (Eigen::Index f = 0; f < std::min(n_free, qr.rank()); ++f)
        result.push_back(candidates[qr.colsPermutation().indices()[f]]);
      return result;
    }
  } // namespace


  bool System::factorize_constant()
  {
    auto &constant = *constant_;
    constant.condensed = false;
    // An iterative solver takes the whole matrix. Its preconditioner has to know the factors of contact: one that was
    // kept took four times as long (doc/decisions/preconditioner.md).
    if (!constant.kept || symmetric_elimination_)
      return false;
    if (constant.prepared && constant.prescribed == prescribed_)
      return constant.condensed = constant.update.set(constant.entries, constant.bordered, prescribed_);

    // Of the constant part alone, so that nothing depends on when it is factorized.
    const auto &candidates = constant.update.candidates();
    const auto diagonal_at = [&](const DofIndex i) {
      if (rows_)
        return constant.diagonal[i];
      const double *const place = entry(i, i);
      const auto first = std::find_if(constant.before.begin(),
                                      constant.before.end(),
                                      [place](const Constant::Before &before) { return before.place == place; });
      return first == constant.before.end() ? *place : first->value;
    };
    Eigen::Index n_free = 0;
    const auto held = hold(constant.motions, candidates, prescribed_, n_free);
    Eigen::VectorXd ground = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(candidates.size()));
    constant.isolated.assign(candidates.size(), false);
    if (held.size() != static_cast<std::size_t>(n_free))
      return false;
    for (unsigned int i = 0; i < candidates.size(); ++i)
    {
      const double diagonal = diagonal_at(candidates[i]);
      if (diagonal == 0. && !prescribed_[candidates[i]])
      {
        constant.isolated[i] = true;
        ground[i] = 1.;
      }
      else if (std::find(held.begin(), held.end(), candidates[i]) != held.end())
        ground[i] = diagonal;
    }
    constant.update.restart(ground);
    if (!constant.update.set(constant.entries, constant.bordered, prescribed_))
      return false;

    double *const staged = stage();
    for (auto old = constant.before.rbegin(); old != constant.before.rend(); ++old)
      staged[old->place - values_] = old->value;
    double scale = 0.;
    for (DofIndex i = 0; i < n_sparse_; ++i)
      if (!prescribed_[i])
        scale = std::max(scale, std::abs(rows_ ? constant.diagonal[i] : staged[entry(i, i) - values_]));
    eliminate(staged, scale, 0.);
    for (unsigned int i = 0; i < candidates.size(); ++i)
      if (owns(candidates[i]) && ground[i] != 0.)
        staged[entry(candidates[i], candidates[i]) - values_] += ground[i];
    hand_over(staged);
    ++n_factorizations_;
    constant.prescribed = prescribed_;
    constant.condensed = constant.prepared = solver_->factorize();
    return constant.condensed;
  }


  bool System::solve_condensed(const Vector &increments, Vector &d)
  {
    auto &constant = *constant_;
    const auto &candidates = constant.update.candidates();
    Vector load(n_sparse_), forces(n_sparse_), further(size());
    const auto compliance = [&](const DofIndex dof, Eigen::VectorXd &result) {
      result.setZero(static_cast<Eigen::Index>(candidates.size()));
      const unsigned int place = constant.update.find(dof);
      if (constant.isolated[place])
      {
        result[place] = 1.;
        return true;
      }
      forces = 0.;
      forces[dof] = 1.;
      if (!solve_sparse(forces, further))
        return false;
      for (unsigned int i = 0; i < candidates.size(); ++i)
        result[i] = further[candidates[i]];
      return true;
    };
    LowRankUpdate::Border border{border_columns_, border_rows_, {}, {}};
    border.block.resize(n_border_, n_border_);
    border.right_side.resize(n_border_);
    for (unsigned int a = 0; a < n_border_; ++a)
    {
      border.right_side[a] = prescribed_[n_sparse_ + a] ? increments[n_sparse_ + a] : -residual_[n_sparse_ + a];
      for (unsigned int b = 0; b < n_border_; ++b)
        border.block(a, b) = border_block_[a * n_border_ + b];
    }

    right_side(increments, load);
    Eigen::VectorXd w;
    if (!solve_sparse(load, d) || !constant.update.solve(d, border, prescribed_, compliance, forces, w))
      return false;
    for (unsigned int i = 0; i < n_sparse_; ++i)
      load[i] -= forces[i];
    if (!solve_sparse(load, d))
      return false;
    constant.update.settle(prescribed_, d);
    for (unsigned int b = 0; b < n_border_; ++b)
    {
      if (!std::isfinite(w[b]))
        return false;
      d[n_sparse_ + b] = w[b];
    }
    return true;
  }


  unsigned int System::n_compliances() const
  {
    return constant_ ? constant_->update.n_columns() : 0;
  }
} // namespace deltaform
