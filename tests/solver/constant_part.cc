// A system of which a part is factorized once, with what contact adds to it, against dense algebra.
#include <deltaform/solver/system.h>

#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include <limits>

using namespace deltaform;

namespace
{
  constexpr unsigned int n_chain = 40, n_sparse = n_chain + 2; ///< a chain of springs and two multipliers

  /// A free chain of springs, held by whatever is added to it; the same as a dense matrix.
  struct Chain
  {
    Chain(const std::string &solver, const unsigned int n_border)
      : n(n_sparse + n_border), system(pattern(), n_border, solver), matrix(Eigen::MatrixXd::Zero(n, n)),
        residual(Eigen::VectorXd::Zero(n))
    {
      system.keep_constant_part({0, 1, 2, 10, 11, 20, 21, 39, 40, 41}, 100);
      Vector translation(n);
      for (unsigned int i = 0; i < n_chain; ++i)
        translation[i] = 1.;
      system.set_near_null_space({translation});
    }

    static dealii::DynamicSparsityPattern pattern()
    {
      dealii::DynamicSparsityPattern result(n_sparse, n_sparse);
      for (unsigned int i = 0; i < n_sparse; ++i)
        result.add(i, i);
      for (unsigned int i = 0; i + 1 < n_chain; ++i)
        for (const auto &[a, b] : {std::pair(i, i + 1), std::pair(i + 1, i)})
          result.add(a, b);
      for (const unsigned int dof : {20, 21})
        for (const auto &[a, b] : {std::pair(dof, dof + 20), std::pair(dof + 20, dof)})
          result.add(a, b);
      return result;
    }

    void add(const std::vector<DofIndex> &dofs, const std::vector<double> &block, const std::vector<double> &vector)
    {
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        residual[dofs[i]] += vector[i];
        for (unsigned int j = 0; j < dofs.size(); ++j)
          matrix(dofs[i], dofs[j]) += block[i * dofs.size() + j];
      }
      system.add(dofs.data(), dofs.size(), system.wants_tangent() ? block.data() : nullptr, vector.data());
    }

    /// The chain, of which the system wants the stiffness once.
    void begin()
    {
      matrix.setZero();
      residual.setZero();
      system.clear(true);
      BOOST_TEST(system.wants_tangent() == (passes_ == 0));
      for (unsigned int i = 0; i + 1 < n_chain; ++i)
        add({i, i + 1}, {3., -3., -3., 3.}, {.1 * i, -.2});
      system.sum_over_ranks();
      BOOST_TEST(system.wants_tangent());
      ++passes_;
    }

    /// A multiplier that ties unknown @p dof, or the equation lambda = 0.
    void multiplier(const DofIndex dof, const bool tied)
    {
      if (tied)
        add({dof, dof + 20}, {0., -1., -1., 0.}, {.3, .01});
      else
        add({dof + 20}, {1.}, {.02});
    }

    void compare(const double tolerance = 1e-12)
    {
      Vector increments(n), d(n);
      Eigen::MatrixXd dense = matrix;
      Eigen::VectorXd load = -residual;
      for (unsigned int i = 0; i < n; ++i)
        if (prescribed[i])
        {
          increments[i] = .01 * i;
          dense.row(i).setZero();
          dense(i, i) = 1.;
          load[i] = increments[i];
        }
      system.set_prescribed(prescribed);
      BOOST_TEST(system.factorize());
      BOOST_TEST(system.solve(increments, d));
      const Eigen::VectorXd exact = dense.fullPivLu().solve(load);
      for (unsigned int i = 0; i < n; ++i)
        BOOST_TEST(std::abs(d[i] - exact[i]) < tolerance * exact.lpNorm<Eigen::Infinity>());
    }

    unsigned int n;
    System system;
    Eigen::MatrixXd matrix;
    Eigen::VectorXd residual;
    std::vector<bool> prescribed = std::vector<bool>(n, false);

  private:
    unsigned int passes_ = 0;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(constant_part)

BOOST_AUTO_TEST_CASE(updates_of_a_free_chain_need_one_factorization)
{
  for (const std::string solver : {"klu", "mumps"})
    BOOST_TEST_CONTEXT("solver " << solver)
    {
      Chain chain(solver, 0);
      for (const double factor : {1e-3, 1., 1e5, 1e10})
      {
        chain.begin();
        chain.add({0}, {factor}, {.5}); // a penalty
        chain.add({10, 11}, {2., 1., -1., 4.}, {0., 1.}); // friction: not symmetric
        chain.multiplier(20, true);
        chain.multiplier(21, false);
        // What others read while contact is added, and the matrix as a whole
        BOOST_TEST(chain.system.diagonal(0) == 3. + factor);
        BOOST_TEST(chain.system.diagonal(10) == 8.);
        double sum = 0.;
        chain.system.for_each_entry([&](DofIndex, DofIndex, const double value) { sum += value; });
        BOOST_TEST(std::abs(sum - chain.matrix.sum()) < 1e-14 * factor + 1e-12);
        chain.compare();
      }
      BOOST_TEST(chain.system.n_factorizations() == 1u);
      // Nothing is left of the last pass.
      chain.begin();
      BOOST_TEST(chain.system.diagonal(0) == 3.);
      BOOST_TEST(chain.system.diagonal(10) == 6.);
    }
}

BOOST_AUTO_TEST_CASE(other_prescribed_unknowns_need_another_one)
{
  Chain chain("klu", 0);
  for (const unsigned int held : {0, 0, 5, 10})
  {
    chain.prescribed.assign(chain.n, false);
    chain.prescribed[held] = true;
    chain.begin();
    chain.add({10, 11}, {20., 1., -1., 4.}, {0., 1.});
    chain.multiplier(20, true);
    chain.multiplier(21, true);
    chain.compare();
  }
  BOOST_TEST(chain.system.n_factorizations() == 3u);
}

BOOST_AUTO_TEST_CASE(a_force_driven_tool_holds_what_is_free_without_it)
{
  for (const bool moved : {false, true})
  {
    Chain chain("klu", 1);
    chain.prescribed[n_sparse] = moved;
    for (const double factor : {10., 1e6})
    {
      chain.begin();
      // The tool presses the first node on, another spring holds the last one.
      chain.add({0, n_sparse}, {factor, -factor, -factor, factor}, {.5, -.25});
      chain.add({39}, {2.}, {0.});
      chain.multiplier(20, false);
      chain.multiplier(21, false);
      // The force is a difference of factor times travel and displacement, in any arithmetic.
      chain.compare(std::max(1e-12, 16 * std::numeric_limits<double>::epsilon() * factor));
    }
    BOOST_TEST(chain.system.n_factorizations() == 1u);
  }
}

BOOST_AUTO_TEST_CASE(what_the_update_cannot_do_the_whole_matrix_does)
{
  Chain chain("klu", 0);
  // An unknown that is no candidate
  chain.begin();
  chain.add({0}, {2.}, {.5});
  chain.add({30}, {2.}, {.5});
  chain.multiplier(20, false);
  chain.multiplier(21, false);
  chain.compare();
  // Nothing holds the chain: the direction comes from a shifted matrix, or there is none.
  chain.begin();
  chain.multiplier(20, false);
  chain.multiplier(21, false);
  Vector zero(chain.n), d(chain.n);
  const bool solved = chain.system.factorize() && chain.system.solve(zero, d);
  BOOST_TEST((!solved || d.linfty_norm() > 1e10));
  chain.begin();
  chain.multiplier(20, false);
  chain.multiplier(21, false);
  BOOST_TEST((chain.system.factorize(1e-6) && chain.system.solve(zero, d)));
  // And back again
  chain.begin();
  chain.add({0}, {2.}, {.5});
  chain.multiplier(20, false);
  chain.multiplier(21, false);
  chain.compare();
}

BOOST_AUTO_TEST_SUITE_END()
