#pragma once
// Residual and tangent as dense arrays, and finite differences against them.
#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/stiffness_view.h>

#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include <functional>

namespace deltaform
{
  namespace testing
  {
    class DenseTarget : public AssemblyTarget, public StiffnessView
    {
    public:
      explicit DenseTarget(const unsigned int n, const bool tangent = true)
        : residual(Eigen::VectorXd::Zero(n)), matrix(Eigen::MatrixXd::Zero(n, n)), tangent_(tangent)
      {
      }

      void add(const DofIndex *dofs, const unsigned int n, const double *m, const double *vector) override
      {
        BOOST_TEST((tangent_ || m == nullptr));
        for (unsigned int i = 0; i < n; ++i)
        {
          residual[dofs[i]] += vector[i];
          for (unsigned int j = 0; m != nullptr && j < n; ++j)
            matrix(dofs[i], dofs[j]) += m[i * n + j];
        }
      }

      bool wants_tangent() const override
      {
        return tangent_;
      }

      void block(const DofIndex *dofs, const unsigned int n, double *result) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            result[i * n + j] = matrix(dofs[i], dofs[j]);
      }

      void multiply(const Vector &direction, Vector &result) const override
      {
        for (unsigned int i = 0; i < matrix.rows(); ++i)
        {
          result[i] = 0.;
          for (unsigned int j = 0; j < matrix.cols(); ++j)
            result[i] += matrix(i, j) * direction[j];
        }
      }

      Eigen::VectorXd residual;
      Eigen::MatrixXd matrix;

    private:
      bool tangent_;
    };

    using Assembly = std::function<void(const Vector &, AssemblyTarget &)>;

    /**
     * The tangent of @p assemble at @p q against differences of fourth order of its residual. Rows and columns are
     * multiplied by @p scale (1 over a typical value of the unknown); errors count relative to the largest entry.
     */
    inline double
    tangent_error(const Assembly &assemble, const Vector &q, const std::vector<double> &scale, const double h)
    {
      const unsigned int n = q.size();
      DenseTarget exact(n);
      assemble(q, exact);
      Eigen::MatrixXd numerical(n, n);
      for (unsigned int j = 0; j < n; ++j)
      {
        const double step = h / scale[j];
        const auto difference = [&](const double s) {
          Vector plus = q, minus = q;
          plus[j] += s;
          minus[j] -= s;
          DenseTarget a(n, false), b(n, false);
          assemble(plus, a);
          assemble(minus, b);
          return Eigen::VectorXd((a.residual - b.residual) / (2. * s));
        };
        numerical.col(j) = (4. * difference(.5 * step) - difference(step)) / 3.;
      }
      double error = 0., largest = 0.;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          const double factor = 1. / (scale[i] * scale[j]);
          error = std::max(error, factor * std::abs(exact.matrix(i, j) - numerical(i, j)));
          largest = std::max(largest, factor * std::abs(exact.matrix(i, j)));
        }
      BOOST_TEST(largest > 0.);
      BOOST_TEST(std::isfinite(error));
      return error / largest;
    }
  } // namespace testing
} // namespace deltaform
