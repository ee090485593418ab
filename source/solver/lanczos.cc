#include "lanczos.h"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace condition
  {
    namespace
    {
      /// A function as Spectra asks for an operator.
      class Operator
      {
      public:
        using Scalar = double;

        Operator(const int n, std::function<Eigen::VectorXd(const Eigen::VectorXd &)> apply)
          : n_(n), apply_(std::move(apply))
        {
        }

        Eigen::Index rows() const
        {
          return n_;
        }

        Eigen::Index cols() const
        {
          return n_;
        }

        void perform_op(const double *const x, double *const y) const
        {
          Eigen::VectorXd::Map(y, n_) = apply_(Eigen::VectorXd::Map(x, n_));
        }

      private:
        int n_;
        std::function<Eigen::VectorXd(const Eigen::VectorXd &)> apply_;
      };
    } // namespace


    double largest_eigenvalue(const int n, const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &apply)
    {
      if (n == 1) // too small for Spectra
        return apply(Eigen::VectorXd::Ones(1))[0];
      Eigen::VectorXd start(n); // without symmetry
      for (int i = 0; i < n; ++i)
        start[i] = 1. + .37 * ((7 * i) % 11);
      start.normalize();
      // Spectra takes residuals below 2e-16 for zero, whatever their unit; the inverse of a stiff matrix is smaller.
      const double size = apply(start).norm();
      if (size == 0.)
        return 0.;
      Operator op(n, [&](const Eigen::VectorXd &x) { return Eigen::VectorXd(apply(x) / size); });
      Spectra::SymEigsSolver<Operator> solver(op, 1, std::min(n, 30));
      solver.init(start.data());
      try
      {
        solver.compute(Spectra::SortRule::LargestAlge, 3000, 1e-6);
      }
      catch (const std::runtime_error &) // of its QR iteration: round-off or overflow has made the products asymmetric
      {
        return std::numeric_limits<double>::infinity();
      }
      if (solver.info() != Spectra::CompInfo::Successful)
        return std::numeric_limits<double>::infinity();
      return size * solver.eigenvalues()[0];
    }
  } // namespace condition
} // namespace deltaform
