#pragma once

#include <Eigen/Core>

#include <functional>

namespace deltaform
{
  namespace condition
  {
    /// Largest eigenvalue of a symmetric positive operator on vectors of @p n numbers, to 1e-6 relative, by Spectra's
    /// implicitly restarted Lanczos method; infinite if that does not converge: then round-off has
    /// destroyed the symmetry of the products, as with the inverse of a matrix that is singular to all digits.
    double largest_eigenvalue(int n, const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &apply);
  } // namespace condition
} // namespace deltaform
