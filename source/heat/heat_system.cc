#include <deltaform/heat/heat_system.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/ranks.h>

#include <Eigen/SparseCholesky>

namespace deltaform
{
  void HeatSystem::add(const DofIndex *const dofs,
                       const unsigned int n,
                       const double *const matrix,
                       const double *const vector)
  {
    for (unsigned int a = 0; a < n; ++a)
    {
      residual_[dofs[a]] += vector[a];
      for (unsigned int b = 0; b < n; ++b)
        if (matrix[a * n + b] != 0.)
          entries_.push_back({dofs[a], dofs[b], matrix[a * n + b]});
    }
  }


  void HeatSystem::share()
  {
    entries_ = ranks::gather(entries_);
    ranks::sum(residual_.begin(), residual_.size());
  }


  Vector HeatSystem::solve() const
  {
    // Only every second unknown of a solid, that of u_r, has a temperature.
    constexpr int none = -1;
    std::vector<int> row(residual_.size(), none);
    std::vector<DofIndex> places;
    for (const auto &entry : entries_)
      if (row[entry.row] == none)
      {
        row[entry.row] = static_cast<int>(places.size());
        places.push_back(entry.row);
      }
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(entries_.size());
    for (const auto &entry : entries_)
      triplets.emplace_back(row[entry.row], row[entry.column], entry.value);
    const auto n = static_cast<int>(places.size());
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success)
      throw SceneError("Material/Heat/Conductivity: heat goes to and fro so fast that nothing of what the blank stores "
                       "is left in numbers of 16 digits. Look at its units, and at the length of the increments.");
    Eigen::VectorXd right(n);
    for (int i = 0; i < n; ++i)
      right[i] = -residual_[places[i]];
    const Eigen::VectorXd solution = factors.solve(right);
    Vector result(residual_.size());
    for (int i = 0; i < n; ++i)
      result[places[i]] = solution[i];
    return result;
  }
} // namespace deltaform
