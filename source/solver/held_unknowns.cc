#include "held_unknowns.h"

#include <Eigen/Dense>

namespace deltaform
{
  std::optional<std::vector<DofIndex>> held_unknowns(const std::vector<Vector> &motions,
                                                     const std::vector<DofIndex> &candidates,
                                                     const std::vector<bool> &prescribed)
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
    const Eigen::Index n_free = (eigen.eigenvalues().array() < 1e-10).count();
    if (n_free == 0)
      return result;
    Eigen::MatrixXd at = Eigen::MatrixXd::Zero(n_free, static_cast<Eigen::Index>(candidates.size()));
    for (Eigen::Index i = 0; i < at.cols(); ++i)
    {
      const DofIndex dof = candidates[i];
      if (prescribed[dof])
        continue;
      for (Eigen::Index f = 0; f < n_free; ++f)
        for (Eigen::Index a = 0; a < n_motions; ++a)
          at(f, i) += eigen.eigenvectors()(a, f) * motions[a][dof];
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(at);
    if (qr.rank() < n_free)
      return std::nullopt;
    for (Eigen::Index f = 0; f < n_free; ++f)
      result.push_back(candidates[qr.colsPermutation().indices()[f]]);
    return result;
  }
} // namespace deltaform
