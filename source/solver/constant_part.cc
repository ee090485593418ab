#include "constant_part.h"

#include "factorization.h"
#include "held_unknowns.h"
#include "prescribed_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    std::vector<DofIndex> sorted(std::vector<DofIndex> dofs)
    {
      std::sort(dofs.begin(), dofs.end());
      dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
      return dofs;
    }
  } // namespace


  ConstantPart::ConstantPart(Tangent &tangent, std::vector<DofIndex> candidates, const std::size_t largest_rank)
    : tangent_(tangent), update_(sorted(std::move(candidates)), largest_rank)
  {
    tangent_.keep_apart();
  }


  bool ConstantPart::restore()
  {
    if (!kept_)
      return false;
    tangent_.clear(&changes_);
    if (tangent_.distributed() != nullptr)
      tangent_.distributed_diagonal() = diagonal_;
    return true;
  }


  void ConstantPart::complete(const bool tangent)
  {
    complete_ = true;
    if (!tangent || kept_)
      return;
    kept_ = true;
    if (tangent_.distributed() != nullptr)
      diagonal_ = tangent_.distributed_diagonal();
  }


  double ConstantPart::diagonal(const DofIndex dof) const
  {
    if (tangent_.distributed() != nullptr)
      return diagonal_[dof];
    const double *const place = tangent_.values() + tangent_.diagonal_place(dof);
    const auto first = std::find_if(changes_.before.begin(),
                                    changes_.before.end(),
                                    [place](const TangentUpdate::Before &before) { return before.place == place; });
    return first == changes_.before.end() ? *place : first->value;
  }


  bool ConstantPart::ground(const std::vector<bool> &prescribed, Eigen::VectorXd &result)
  {
    const auto &candidates = update_.candidates();
    const auto held = held_unknowns(motions_, candidates, prescribed);
    if (!held)
      return false;
    result.setZero(static_cast<Eigen::Index>(candidates.size()));
    isolated_.assign(candidates.size(), false);
    for (unsigned int i = 0; i < candidates.size(); ++i)
    {
      const double here = diagonal(candidates[i]);
      if (here == 0. && !prescribed[candidates[i]])
      {
        isolated_[i] = true;
        result[i] = 1.;
      }
      else if (std::find(held->begin(), held->end(), candidates[i]) != held->end())
        result[i] = here;
    }
    return true;
  }


  bool ConstantPart::factorize(PrescribedRows &rows, Factorization &factorization)
  {
    condensed_ = false;
    // An iterative solver takes the whole matrix. Its preconditioner has to know the factors of contact: one that was
    // kept took four times as long (doc/decisions/README.md).
    if (!kept_ || rows.symmetric())
      return false;
    const auto &prescribed = rows.prescribed();
    if (prepared_ && prescribed_ == prescribed)
      return condensed_ = update_.set(changes_.entries, changes_.bordered, prescribed_);

    Eigen::VectorXd ground;
    if (!this->ground(prescribed, ground))
      return false;
    update_.restart(ground);
    if (!update_.set(changes_.entries, changes_.bordered, prescribed))
      return false;

    drop();
    double *const staged = tangent_.stage();
    for (auto old = changes_.before.rbegin(); old != changes_.before.rend(); ++old)
      staged[old->place - tangent_.values()] = old->value;
    const bool distributed = tangent_.distributed() != nullptr;
    double scale = 0.;
    for (DofIndex i = 0; i < tangent_.n_sparse(); ++i)
      if (!prescribed[i])
        scale = std::max(scale, std::abs(distributed ? diagonal_[i] : staged[tangent_.diagonal_place(i)]));
    rows.eliminate(staged, tangent_, scale, 0.);
    for (unsigned int i = 0; i < update_.candidates().size(); ++i)
      if (const DofIndex dof = update_.candidates()[i]; tangent_.owns(dof) && ground[i] != 0.)
        staged[tangent_.diagonal_place(dof)] += ground[i];
    prescribed_ = prescribed;
    condensed_ = prepared_ = factorization.factorize(staged);
    return condensed_;
  }


  bool ConstantPart::compliance(Factorization &factorization, const DofIndex dof, Eigen::VectorXd &result) const
  {
    const auto &candidates = update_.candidates();
    result.setZero(static_cast<Eigen::Index>(candidates.size()));
    const unsigned int place = update_.find(dof);
    if (isolated_[place])
    {
      result[place] = 1.;
      return true;
    }
    Vector unit(tangent_.n_sparse()), column(tangent_.n_sparse());
    unit[dof] = 1.;
    if (!factorization.solve(unit, column))
      return false;
    for (unsigned int i = 0; i < candidates.size(); ++i)
      result[i] = column[candidates[i]];
    return true;
  }


  bool ConstantPart::solve(Factorization &factorization,
                           const PrescribedRows &rows,
                           const Vector &residual,
                           const Vector &increments,
                           Vector &d)
  {
    const unsigned int n = tangent_.n_sparse(), n_border = tangent_.n_border();
    const auto &prescribed = rows.prescribed();
    LowRankUpdate::Border border{tangent_.border().columns(), tangent_.border().rows(), {}, {}};
    border.block.resize(n_border, n_border);
    border.right_side.resize(n_border);
    for (unsigned int a = 0; a < n_border; ++a)
    {
      border.right_side[a] = prescribed[n + a] ? increments[n + a] : -residual[n + a];
      for (unsigned int b = 0; b < n_border; ++b)
        border.block(a, b) = tangent_.border().block(a, b);
    }

    Vector load(n), forces(n);
    rows.right_side(residual, increments, load);
    Eigen::VectorXd w;
    const auto column = [&](const DofIndex dof, Eigen::VectorXd &result) {
      return compliance(factorization, dof, result);
    };
    if (!factorization.solve(load, d) || !update_.solve(d, border, prescribed, column, forces, w))
      return false;
    load -= forces;
    if (!factorization.solve(load, d))
      return false;
    update_.restore_digits(prescribed, d);
    for (unsigned int b = 0; b < n_border; ++b)
    {
      if (!std::isfinite(w[b]))
        return false;
      d[n + b] = w[b];
    }
    return true;
  }
} // namespace deltaform
