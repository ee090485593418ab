#pragma once

#include <deltaform/solver/condition_method.h>
#include <deltaform/solver/system.h>

#include <Eigen/SparseCore>

#include <vector>

namespace deltaform
{
  /**
   * Condition numbers of matrices of the free unknowns. kappa_2 = largest over smallest singular value: by a dense
   * singular value decomposition (Eigen) or by Lanczos iterations (Spectra) on A^T A and on A^-1 A^-T with a sparse LU
   * factorization.
   */
  namespace condition
  {
    using Matrix = Eigen::SparseMatrix<double>;

    /// Position of every unknown of a system among the free ones, -1: prescribed.
    std::vector<int> free_numbers(const System &system);

    /// The assembled tangent without the rows and columns of prescribed unknowns; the border (travels of force-driven
    /// tools) is part of it.
    Matrix free_matrix(const System &system);

    /// kappa_2 of @p A; infinity if it is singular to working precision.
    double number(const Matrix &A, Method method = Method::automatic);

    /// kappa_2 of @p A on the complement of the span of @p modes (columns, orthonormal), which A maps to (nearly) zero.
    double number_on_complement(const Matrix &A, const Eigen::MatrixXd &modes, Method method = Method::automatic);

    /// Two unknowns of a node, displacements along r and z, and a direction: the node's normal/tangential frame.
    struct Frame
    {
      int r, z;
      Tensor1 normal;
    };

    /// D^-1/2 T^T A T D^-1/2 with T the rotation into the frames and D the absolute diagonal (where that vanishes, as
    /// for multipliers, the largest entry of the row).
    Matrix scale_in_frames(const Matrix &A, const std::vector<Frame> &frames);

    /**
     * Decimal digits that a direct solution of A y = A x loses: log10 of its relative error over the unit round-off.
     * The exact solution comes from iterative refinement with residuals in long double.
     */
    double digits_lost(const Matrix &A, const Eigen::VectorXd &x);
  } // namespace condition
} // namespace deltaform
