#include "lanczos.h"

#include <deltaform/solver/condition.h>

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace condition
  {
    namespace
    {
      using Factorization = Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>>;

      constexpr unsigned int largest_dense = 300;
      constexpr double infinite = std::numeric_limits<double>::infinity();

      bool use_dense(const Matrix &A, const Method method)
      {
        return method == Method::dense || (method == Method::automatic && A.rows() <= largest_dense);
      }

      double largest_singular_value(const Matrix &A)
      {
        return std::sqrt(largest_eigenvalue(
          A.rows(), [&](const Eigen::VectorXd &x) { return Eigen::VectorXd(A.transpose() * (A * x)); }));
      }
    } // namespace


    std::vector<int> free_numbers(const System &system)
    {
      std::vector<int> numbers(system.size(), -1);
      int next = 0;
      for (unsigned int i = 0; i < numbers.size(); ++i)
        if (!system.prescribed(i))
          numbers[i] = next++;
      return numbers;
    }


    Matrix free_matrix(const System &system)
    {
      const std::vector<int> numbers = free_numbers(system);
      const int n = numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1;
      std::vector<Eigen::Triplet<double>> entries;
      system.for_each_entry(
        [&](const DofIndex i, const DofIndex j, const double value) {
          if (numbers[i] >= 0 && numbers[j] >= 0 && value != 0.)
            entries.emplace_back(numbers[i], numbers[j], value);
        });
      Matrix A(n, n);
      A.setFromTriplets(entries.begin(), entries.end());
      return A;
    }


    double number(const Matrix &A, const Method method)
    {
      if (A.rows() == 0)
        return 1.;
      if (use_dense(A, method))
      {
        const Eigen::VectorXd values = Eigen::BDCSVD<Eigen::MatrixXd>(Eigen::MatrixXd(A)).singularValues();
        return values.minCoeff() > 0 ? values.maxCoeff() / values.minCoeff() : infinite;
      }
      Factorization lu(A);
      if (lu.info() != Eigen::Success)
        return infinite;
      const double inverse = std::sqrt(largest_eigenvalue(A.rows(),
                                                          [&](const Eigen::VectorXd &x) {
                                                            const Eigen::VectorXd y = lu.transpose().solve(x);
                                                            return Eigen::VectorXd(lu.solve(y));
                                                          }));
      return largest_singular_value(A) * inverse;
    }


    double number_on_complement(const Matrix &A, const Eigen::MatrixXd &modes, const Method method)
    {
      const int n = A.rows(), m = modes.cols();
      if (m == 0)
        return number(A, method);
      if (use_dense(A, method))
      {
        // An orthonormal basis of the complement: the last columns of Q.
        const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(modes).householderQ();
        const Eigen::MatrixXd Z = Q.rightCols(n - m);
        const Eigen::VectorXd values =
          Eigen::BDCSVD<Eigen::MatrixXd>(Z.transpose() * Eigen::MatrixXd(A) * Z).singularValues();
        return values.minCoeff() > 0 ? values.maxCoeff() / values.minCoeff() : infinite;
      }
      // [A V; V^T 0] [x; m] = [f; 0] solves A x = f on the complement of V.
      std::vector<Eigen::Triplet<double>> entries;
      for (int k = 0; k < A.outerSize(); ++k)
        for (Matrix::InnerIterator entry(A, k); entry; ++entry)
          entries.emplace_back(entry.row(), entry.col(), entry.value());
      const double size = largest_singular_value(A);
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < m; ++k)
        {
          entries.emplace_back(i, n + k, size * modes(i, k));
          entries.emplace_back(n + k, i, size * modes(i, k));
        }
      Matrix bordered(n + m, n + m);
      bordered.setFromTriplets(entries.begin(), entries.end());
      Factorization lu(bordered);
      if (lu.info() != Eigen::Success)
        return infinite;
      const auto apply = [&](const Eigen::VectorXd &x, const bool transposed) {
        Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n + m);
        right_side.head(n) = x;
        const Eigen::VectorXd y =
          transposed ? Eigen::VectorXd(lu.transpose().solve(right_side)) : Eigen::VectorXd(lu.solve(right_side));
        return Eigen::VectorXd(y.head(n));
      };
      return size *
             std::sqrt(largest_eigenvalue(n, [&](const Eigen::VectorXd &x) { return apply(apply(x, true), false); }));
    }


    Matrix scale_in_frames(const Matrix &A, const std::vector<Frame> &frames)
    {
      const int n = A.rows();
      std::vector<Eigen::Triplet<double>> entries;
      std::vector<bool> rotated(n, false);
      for (const auto &[r, z, normal] : frames)
      {
        // Columns: normal and tangent.
        entries.emplace_back(r, r, normal[0]);
        entries.emplace_back(z, r, normal[1]);
        entries.emplace_back(r, z, -normal[1]);
        entries.emplace_back(z, z, normal[0]);
        rotated[r] = rotated[z] = true;
      }
      for (int i = 0; i < n; ++i)
        if (!rotated[i])
          entries.emplace_back(i, i, 1.);
      Matrix T(n, n);
      T.setFromTriplets(entries.begin(), entries.end());
      Matrix B = T.transpose() * A * T;

      Eigen::VectorXd diagonal = B.diagonal().cwiseAbs(), largest = Eigen::VectorXd::Zero(n);
      for (int k = 0; k < B.outerSize(); ++k)
        for (Matrix::InnerIterator entry(B, k); entry; ++entry)
          largest[entry.row()] = std::max(largest[entry.row()], std::abs(entry.value()));
      for (int i = 0; i < n; ++i)
        if (!(diagonal[i] > 1e-14 * largest[i]))
          diagonal[i] = largest[i] > 0 ? largest[i] : 1.;
      const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
      return scale.asDiagonal() * B * scale.asDiagonal();
    }


    double digits_lost(const Matrix &A, const Eigen::VectorXd &x)
    {
      using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
      if (!(x.norm() > 0))
        return std::numeric_limits<double>::quiet_NaN();
      const Eigen::SparseMatrix<long double> exact_matrix = A.cast<long double>();
      const Eigen::VectorXd b = (exact_matrix * x.cast<long double>()).cast<double>();
      Factorization lu(A);
      if (lu.info() != Eigen::Success)
        return std::numeric_limits<double>::quiet_NaN();
      const Eigen::VectorXd first = lu.solve(b);
      Long refined = first.cast<long double>();
      double last = infinite;
      for (unsigned int round = 0; round < 50; ++round)
      {
        const Eigen::VectorXd residual = (b.cast<long double>() - exact_matrix * refined).cast<double>();
        const Eigen::VectorXd correction = lu.solve(residual);
        if (!(correction.norm() < last))
          break;
        last = correction.norm();
        refined += correction.cast<long double>();
      }
      const double error = static_cast<double>((first.cast<long double>() - refined).norm() / refined.norm());
      return std::max(0., std::log10(error / (.5 * std::numeric_limits<double>::epsilon())));
    }
  } // namespace condition
} // namespace deltaform
