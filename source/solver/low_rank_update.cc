#include "low_rank_update.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace deltaform
{
  LowRankUpdate::LowRankUpdate(std::vector<DofIndex> candidates, const std::size_t largest_rank)
    : candidates_(std::move(candidates)), largest_rank_(largest_rank),
      ground_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(candidates_.size()))), columns_(candidates_.size())
  {
  }


  unsigned int LowRankUpdate::find(const DofIndex dof) const
  {
    const auto place = std::lower_bound(candidates_.begin(), candidates_.end(), dof);
    return place != candidates_.end() && *place == dof ? static_cast<unsigned int>(place - candidates_.begin())
                                                       : invalid_index;
  }


  void LowRankUpdate::restart(const Eigen::VectorXd &ground)
  {
    ground_ = ground;
    for (auto &column : columns_)
      column.resize(0);
  }


  namespace
  {
    /// D by candidates.
    using SparseSum = std::map<std::pair<unsigned int, unsigned int>, double>;

    /// The block of every candidate in @p all, rising: unknowns that D couples get the same, that of the least of them.
    std::vector<std::size_t> coupled_blocks(const SparseSum &sum, const std::vector<unsigned int> &all)
    {
      std::vector<std::size_t> block(all.size());
      std::iota(block.begin(), block.end(), std::size_t(0));
      const auto place_in = [](const std::vector<unsigned int> &list, const unsigned int candidate) {
        return static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), candidate) - list.begin());
      };
      for (const auto &[place, value] : sum)
        if (value != 0.)
        {
          const std::size_t one = block[place_in(all, place.first)], other = block[place_in(all, place.second)];
          if (one != other)
            std::replace(block.begin(), block.end(), std::max(one, other), std::min(one, other));
        }
      return block;
    }
  } // namespace


  bool LowRankUpdate::set(const std::vector<UpdateEntry> &entries,
                          const std::vector<DofIndex> &bordered,
                          const std::vector<bool> &prescribed)
  {
    SparseSum sum;
    for (unsigned int i = 0; i < candidates_.size(); ++i)
      if (ground_[i] != 0.)
        sum[{i, i}] = -ground_[i];
    for (const auto &[row, column, value] : entries)
    {
      if (prescribed[row])
        continue;
      const unsigned int i = find(row), j = find(column);
      if (i == invalid_index || j == invalid_index)
        return false;
      sum[{i, j}] += value;
    }
    std::vector<unsigned int> all;
    for (const auto &[place, value] : sum)
      if (value != 0.)
      {
        all.push_back(place.first);
        all.push_back(place.second);
      }
    for (const auto dof : bordered)
      all.push_back(find(dof));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.size() > largest_rank_ || (!all.empty() && all.back() == invalid_index))
      return false;

    const auto block = coupled_blocks(sum, all);
    active_.clear();
    blocks_.clear();
    for (std::size_t b = 0; b < all.size(); ++b)
    {
      const std::size_t first = active_.size();
      for (std::size_t i = b; i < all.size(); ++i)
        if (block[i] == b)
          active_.push_back(all[i]);
      const auto n = static_cast<Eigen::Index>(active_.size() - first);
      if (n == 0)
        continue;
      Eigen::MatrixXd D(n, n);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
        {
          const auto entry = sum.find({active_[first + i], active_[first + j]});
          D(i, j) = entry == sum.end() ? 0. : entry->second;
        }
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(D, Eigen::ComputeFullU | Eigen::ComputeFullV);
      blocks_.push_back({static_cast<Eigen::Index>(first), svd.matrixU(), svd.matrixV(), svd.singularValues()});
    }
    return true;
  }


  bool LowRankUpdate::complete_columns(const Compliance &compliance)
  {
    for (const auto place : active_)
    {
      auto &column = columns_[place];
      if (column.size() != 0)
        continue;
      if (!compliance(candidates_[place], column))
        return false;
      ++n_columns_;
    }
    return true;
  }


  LowRankUpdate::Reduced
  LowRankUpdate::reduce(const Vector &d, const Border &border, const std::vector<bool> &prescribed) const
  {
    const auto m = static_cast<Eigen::Index>(active_.size()), n_border = border.block.rows();
    Reduced result;
    result.B.resize(m, n_border);
    result.C.resize(n_border, m);
    result.matrix.resize(m + n_border, m + n_border);
    result.right_side.resize(m + n_border);
    for (Eigen::Index j = 0; j < m; ++j)
    {
      const DofIndex dof = candidates_[active_[j]];
      for (Eigen::Index b = 0; b < n_border; ++b)
      {
        result.B(j, b) = prescribed[dof] ? 0. : border.columns[b][dof];
        result.C(b, j) = border.rows[b][dof];
      }
      for (Eigen::Index i = 0; i < m; ++i)
        result.matrix(i, j) = columns_[active_[j]][active_[i]];
      result.right_side[j] = d[dof];
    }
    result.matrix.topRightCorner(m, n_border).noalias() = result.matrix.topLeftCorner(m, m) * result.B;
    result.matrix.bottomRightCorner(n_border, n_border) = border.block;
    result.right_side.tail(n_border) = border.right_side;
    return result;
  }


  Eigen::VectorXd LowRankUpdate::turn_to_principal(Reduced &reduced)
  {
    auto &matrix = reduced.matrix;
    const auto m = static_cast<Eigen::Index>(active_.size()), n_border = matrix.rows() - m;
    for (const auto &block : blocks_)
    {
      const auto n = block.factors.size();
      auto of_block = matrix.middleRows(block.first, n);
      of_block = (block.right.transpose() * of_block).eval();
      auto right_side = reduced.right_side.segment(block.first, n);
      right_side = (block.right.transpose() * right_side).eval();
      reduced.C.middleCols(block.first, n) = (reduced.C.middleCols(block.first, n) * block.right).eval();
    }
    Eigen::VectorXd columns = Eigen::VectorXd::Ones(m + n_border);
    stiff_.clear();
    for (const auto &block : blocks_)
    {
      const auto n = block.factors.size();
      auto columns_of_block = matrix.block(0, block.first, m, n);
      columns_of_block = (columns_of_block * block.left).eval();
      for (Eigen::Index k = 0; k < n; ++k)
      {
        const Eigen::Index j = block.first + k;
        const double factor = block.factors[k], compliance_here = matrix.col(j).head(m).lpNorm<Eigen::Infinity>();
        const bool stiff = factor * compliance_here > 1.;
        stiff_.push_back(stiff);
        columns[j] = stiff ? 1. : factor;
        matrix.col(j).head(m) *= columns[j];
        matrix(j, j) += stiff ? 1. / factor : 1.;
        matrix.col(j).tail(n_border) = reduced.C.col(j) * (stiff ? 1. / factor : 1.);
      }
    }
    return columns;
  }


  namespace
  {
    /// Solve with columns and rows scaled to a largest entry of one; the solution is multiplied by @p columns.
    /// @return false if the matrix is (nearly) singular
    bool solve_scaled(Eigen::MatrixXd &matrix,
                      Eigen::VectorXd &right_side,
                      Eigen::VectorXd &columns,
                      Eigen::VectorXd &solution)
    {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      {
        const double largest = matrix.col(j).lpNorm<Eigen::Infinity>();
        if (!(largest > 0.))
          return false;
        matrix.col(j) /= largest;
        columns[j] /= largest;
      }
      for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      {
        const double largest = matrix.row(i).lpNorm<Eigen::Infinity>();
        if (!(largest > 0.))
          return false;
        matrix.row(i) /= largest;
        right_side[i] /= largest;
      }
      solution.resize(matrix.rows());
      if (matrix.rows() == 0)
        return true;
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
      constexpr double singular = 1e-13;
      if (!(lu.rcond() > singular))
        return false;
      solution = columns.cwiseProduct(lu.solve(right_side));
      return true;
    }
  } // namespace


  bool LowRankUpdate::solve(const Vector &d,
                            const Border &border,
                            const std::vector<bool> &prescribed,
                            const Compliance &compliance,
                            Vector &forces,
                            Eigen::VectorXd &w)
  {
    if (!complete_columns(compliance))
      return false;
    Reduced reduced = reduce(d, border, prescribed);
    Eigen::VectorXd columns = turn_to_principal(reduced);
    const auto m = static_cast<Eigen::Index>(active_.size()), n_border = border.block.rows();
    const DofIndex first = d.size() - n_border;
    for (Eigen::Index b = 0; b < n_border; ++b)
      if (prescribed[first + b])
      {
        reduced.matrix.row(m + b).setZero();
        reduced.matrix(m + b, m + b) = 1.;
      }
    Eigen::VectorXd solution;
    if (!solve_scaled(reduced.matrix, reduced.right_side, columns, solution))
      return false;
    w = solution.tail(n_border);
    Eigen::VectorXd at_A = reduced.B * w;
    for (const auto &block : blocks_)
      at_A.segment(block.first, block.factors.size()) +=
        block.left * solution.segment(block.first, block.factors.size());
    principal_ = solution.head(m);
    forces = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      forces[candidates_[active_[i]]] = at_A[i];
    return true;
  }


  void LowRankUpdate::restore_digits(const std::vector<bool> &prescribed, Vector &d) const
  {
    for (const auto &block : blocks_)
    {
      Eigen::VectorXd at(block.factors.size());
      for (Eigen::Index k = 0; k < at.size(); ++k)
        at[k] = d[candidates_[active_[block.first + k]]];
      Eigen::VectorXd directions = block.right.transpose() * at;
      for (Eigen::Index k = 0; k < at.size(); ++k)
        if (stiff_[block.first + k])
          directions[k] = principal_[block.first + k] / block.factors[k];
      at = block.right * directions;
      for (Eigen::Index k = 0; k < at.size(); ++k)
      {
        const DofIndex dof = candidates_[active_[block.first + k]];
        if (!prescribed[dof])
          d[dof] = at[k];
      }
    }
  }
} // namespace deltaform
