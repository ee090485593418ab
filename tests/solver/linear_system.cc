// The sparse system with its eliminated border against dense algebra.
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/solver/linear_method.h>
#include <deltaform/solver/system.h>

#include "mpi.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include <random>

using namespace deltaform;

namespace
{
  constexpr unsigned int n_sparse = 30;

  /// A system of random elements of four unknowns each, and the same as a dense matrix.
  struct Assembled
  {
    Assembled(const std::string &solver, const unsigned int n_border)
      : n(n_sparse + n_border), system(pattern(), n_border, solver), matrix(Eigen::MatrixXd::Zero(n, n)),
        residual(Eigen::VectorXd::Zero(n)), magnitude(Eigen::VectorXd::Zero(n))
    {
    }

    static dealii::DynamicSparsityPattern pattern()
    {
      dealii::DynamicSparsityPattern result(n_sparse, n_sparse);
      for (unsigned int e = 0; e + 4 <= n_sparse; ++e)
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
            result.add(e + i, e + j);
      for (unsigned int i = 0; i < n_sparse; ++i)
        result.add(i, i);
      return result;
    }

    void fill(std::mt19937 &generator, const bool tangent = true)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      system.clear(tangent);
      BOOST_TEST(system.wants_tangent() == tangent);
      matrix.setZero();
      residual.setZero();
      magnitude.setZero();
      for (unsigned int e = 0; e + 4 <= n_sparse; ++e)
      {
        // four neighbours and, every now and then, the unknowns of the border
        std::vector<DofIndex> dofs{e, e + 1, e + 2, e + 3};
        for (unsigned int b = n_sparse; b < n; ++b)
          if (e % 3 != b % 2)
            dofs.push_back(b);
        const unsigned int m = dofs.size();
        std::vector<double> block(m * m), vector(m);
        for (unsigned int i = 0; i < m; ++i)
        {
          vector[i] = uniform(generator);
          residual[dofs[i]] += vector[i];
          magnitude[dofs[i]] += std::abs(vector[i]);
          for (unsigned int j = 0; j < m; ++j)
          {
            block[i * m + j] = uniform(generator) + (i == j ? 3. : 0.);
            matrix(dofs[i], dofs[j]) += block[i * m + j];
          }
        }
        system.add(dofs.data(), m, tangent ? block.data() : nullptr, vector.data());
      }
    }

    unsigned int n;
    System system;
    Eigen::MatrixXd matrix;
    Eigen::VectorXd residual, magnitude;
  };

  void compare(Assembled &assembled, const std::vector<bool> &prescribed, std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Vector increments(assembled.n), d(assembled.n);
    Eigen::MatrixXd matrix = assembled.matrix;
    Eigen::VectorXd load = -assembled.residual;
    for (unsigned int i = 0; i < assembled.n; ++i)
      if (prescribed[i])
      {
        increments[i] = uniform(generator);
        matrix.row(i).setZero();
        matrix(i, i) = 1.;
        load[i] = increments[i];
      }
    assembled.system.set_prescribed(prescribed);
    BOOST_TEST(assembled.system.factorize());
    BOOST_TEST(assembled.system.solve(increments, d));
    const Eigen::VectorXd exact = matrix.partialPivLu().solve(load);
    for (unsigned int i = 0; i < assembled.n; ++i)
    {
      BOOST_TEST(std::abs(d[i] - exact[i]) < 1e-11 * (1. + exact.norm()));
      if (prescribed[i])
        BOOST_TEST(std::abs(d[i] - increments[i]) < 1e-15);
    }
  }

  /// Those that factorize; the iterative ones have tests on whole runs (tests/distributed).
  void for_all_solvers(const std::function<void(const std::string &)> &body)
  {
    ParameterTree tree = ParameterTree::documentation();
    Section section = tree.root();
    unsigned int n = 0;
    for (const auto &solver : Registry<LinearMethod>::names())
      if (!Registry<LinearMethod>::make(solver, section)->iterative())
        BOOST_TEST_CONTEXT("solver " << solver)
        {
          body(solver);
          ++n;
        }
    BOOST_TEST(n >= 2u);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(linear_system)

BOOST_AUTO_TEST_CASE(solutions_are_those_of_dense_algebra)
{
  for_all_solvers(
    [](const std::string &solver) {
      for (const unsigned int n_border : {0, 1, 2})
        BOOST_TEST_CONTEXT("border " << n_border)
        {
          std::mt19937 generator(1);
          Assembled assembled(solver, n_border);
          BOOST_TEST(assembled.system.size() == n_sparse + n_border);
          // The pattern and the symbolic factorization are kept from one matrix to the next.
          for (unsigned int k = 0; k < 5; ++k)
          {
            assembled.fill(generator);
            std::vector<bool> prescribed(assembled.n, false);
            for (unsigned int i = 0; i < n_sparse; ++i)
              prescribed[i] = k > 0 && generator() % 5 == 0;
            compare(assembled, prescribed, generator);
          }
          BOOST_TEST(assembled.system.n_factorizations() == 5u);
        }
    });
}

BOOST_AUTO_TEST_CASE(a_pass_goes_on_from_what_was_kept_in_it)
{
  std::mt19937 generator(7);
  Assembled assembled("klu", 1), other("mumps", 1);
  System &system = assembled.system;
  assembled.fill(generator, false);
  BOOST_TEST(!system.keep()); // no tangent
  other.fill(generator);
  BOOST_TEST(!other.system.keep()); // a factorization is dear
  assembled.fill(generator);
  BOOST_TEST(system.keep());
  const auto spring = [&](const DofIndex row, const double stiffness) {
    const DofIndex dofs[] = {row, n_sparse};
    const double block[] = {stiffness, -stiffness, -stiffness, stiffness}, force[] = {stiffness, -stiffness};
    system.add(dofs, 2, block, force);
  };
  const std::vector<bool> free(assembled.n, false);
  system.set_prescribed(free);
  spring(3, 10.);
  BOOST_TEST(system.factorize());
  for (unsigned int time = 0; time < 2; ++time)
  {
    system.go_back();
    spring(5 + time, 20.);
  }
  assembled.matrix(6, 6) += 20.;
  assembled.matrix(6, n_sparse) -= 20.;
  assembled.matrix(n_sparse, 6) -= 20.;
  assembled.matrix(n_sparse, n_sparse) += 20.;
  assembled.residual[6] += 20.;
  assembled.residual[n_sparse] -= 20.;
  assembled.magnitude[6] += 20.;
  assembled.magnitude[n_sparse] += 20.;
  for (unsigned int i = 0; i < assembled.n; ++i)
  {
    BOOST_TEST(system.residual()[i] == assembled.residual[i]);
    BOOST_TEST(system.magnitude()[i] == assembled.magnitude[i]);
  }
  compare(assembled, free, generator);
}

BOOST_AUTO_TEST_CASE(residual_of_the_linear_equations)
{
  for (const unsigned int n_border : {0, 1, 2})
  {
    std::mt19937 generator(4);
    Assembled assembled("klu", n_border);
    assembled.fill(generator);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Eigen::VectorXd step(assembled.n);
    Vector d(assembled.n), result(assembled.n);
    for (unsigned int i = 0; i < assembled.n; ++i)
      d[i] = step[i] = uniform(generator);
    const Eigen::VectorXd exact = assembled.residual + assembled.matrix * step;
    assembled.system.linear_residual(d, result);
    for (unsigned int i = 0; i < assembled.n; ++i)
      BOOST_TEST(std::abs(result[i] - exact[i]) < 1e-13 * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(prescribed_unknowns_of_the_border)
{
  for_all_solvers(
    [](const std::string &solver) {
      std::mt19937 generator(2);
      Assembled assembled(solver, 2);
      for (const bool first : {false, true})
        for (const bool second : {false, true})
        {
          assembled.fill(generator);
          std::vector<bool> prescribed(assembled.n, false);
          prescribed[3] = prescribed[17] = true;
          prescribed[n_sparse] = first;
          prescribed[n_sparse + 1] = second;
          compare(assembled, prescribed, generator);
        }
    });
}

BOOST_AUTO_TEST_CASE(what_was_assembled_can_be_read)
{
  std::mt19937 generator(3);
  Assembled assembled("klu", 1);
  assembled.fill(generator);
  const System &system = assembled.system;
  for (unsigned int i = 0; i < assembled.n; ++i)
  {
    BOOST_TEST(std::abs(system.residual()[i] - assembled.residual[i]) < 1e-14);
    BOOST_TEST(std::abs(system.magnitude()[i] - assembled.magnitude[i]) < 1e-14);
    BOOST_TEST(std::abs(system.diagonal(i) - (i < n_sparse ? assembled.matrix(i, i) : 0.)) < 1e-14);
  }
  BOOST_TEST(std::abs(system.largest_diagonal() -
                      assembled.matrix.topLeftCorner(n_sparse, n_sparse).diagonal().maxCoeff()) < 1e-14);

  const DofIndex dofs[] = {5, 7, 6};
  std::array<double, 9> block;
  system.block(dofs, 3, block.data());
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      BOOST_TEST(std::abs(block[3 * i + j] - assembled.matrix(dofs[i], dofs[j])) < 1e-14);

  Vector direction(assembled.n), result(assembled.n);
  Eigen::VectorXd dense = Eigen::VectorXd::Zero(assembled.n);
  for (unsigned int i = 0; i < n_sparse; ++i)
    dense[i] = direction[i] = .1 * i - 1.;
  system.multiply(direction, result);
  const Eigen::VectorXd exact = assembled.matrix * dense;
  for (unsigned int i = 0; i < n_sparse; ++i)
    BOOST_TEST(std::abs(result[i] - exact[i]) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_pass_without_tangent_keeps_it)
{
  std::mt19937 generator(4);
  Assembled assembled("klu", 1);
  assembled.fill(generator);
  const double before = assembled.system.diagonal(4);
  assembled.fill(generator, false);
  BOOST_TEST(assembled.system.diagonal(4) == before);
  BOOST_TEST(std::abs(assembled.system.residual()[4] - assembled.residual[4]) < 1e-14);
}

BOOST_AUTO_TEST_CASE(singular_systems_are_reported)
{
  for_all_solvers(
    [](const std::string &solver) {
      // A free unknown without stiffness
      dealii::DynamicSparsityPattern pattern(3, 3);
      for (unsigned int i = 0; i < 3; ++i)
        pattern.add(i, i);
      System system(std::move(pattern), 0, solver);
      const auto assemble = [&](const double last) {
        system.clear(true);
        const double values[] = {2., 5., last}, load = 1.;
        for (DofIndex i = 0; i < 3; ++i)
          system.add(&i, 1, &values[i], &load);
      };
      Vector zero(3), d(3);
      assemble(1.);
      BOOST_TEST((system.factorize() && system.solve(zero, d)));
      assemble(0.);
      BOOST_TEST(!(system.factorize() && system.solve(zero, d)));
      // A prescribed unknown needs none; and a shift gives a direction all the same.
      system.set_prescribed({false, false, true});
      assemble(0.);
      BOOST_TEST((system.factorize() && system.solve(zero, d)));
      BOOST_TEST(std::abs(d[0] + .5) < 1e-15);
      system.set_prescribed({false, false, false});
      assemble(0.);
      BOOST_TEST((system.factorize(1e-6) && system.solve(zero, d)));
      BOOST_TEST(std::abs(d[0] + .5) < 1e-6);
    });
}

BOOST_AUTO_TEST_CASE(a_border_that_nothing_holds_is_reported)
{
  dealii::DynamicSparsityPattern pattern(1, 1);
  pattern.add(0, 0);
  System system(std::move(pattern), 1, "klu");
  const DofIndex dofs[] = {0, 1};
  const double load[] = {1., 1.};
  Vector zero(2), d(2);
  for (const double coupling : {0., 1.})
  {
    const double block[] = {2., coupling, coupling, 0.};
    system.clear(true);
    system.add(dofs, 2, block, load);
    BOOST_TEST(system.factorize());
    BOOST_TEST(system.solve(zero, d) == (coupling != 0.));
  }
}

BOOST_AUTO_TEST_CASE(elements_may_come_in_another_order)
{
  // Places of entries are remembered by the order of the elements; integers, so that sums do not depend on it.
  Assembled assembled("klu", 1);
  auto &system = assembled.system;
  const std::vector<std::vector<DofIndex>> elements{{0, 1, 2, 3}, {1, 2, 3, 4}, {3, 4}, {n_sparse, 5, 6}, {4, 5, 6, 7}};
  const auto pass = [&](const std::vector<unsigned int> &order) {
    system.clear(true);
    for (const auto e : order)
    {
      const auto n = static_cast<unsigned int>(elements[e].size());
      std::vector<double> block(n * n), vector(n, 0.);
      for (unsigned int i = 0; i < n * n; ++i)
        block[i] = 1. + i + 10. * e;
      system.add(elements[e].data(), n, block.data(), vector.data());
    }
    std::vector<double> values;
    system.for_each_entry([&](DofIndex, DofIndex, const double value) { values.push_back(value); });
    return values;
  };
  const auto values = pass({0, 1, 2, 3, 4});
  for (const auto &order :
       std::vector<std::vector<unsigned int>>{{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {0, 1, 3, 2, 4}, {0, 1, 2, 3, 4}})
    BOOST_TEST(pass(order) == values, boost::test_tools::per_element());
  // And one that is left out is left out.
  BOOST_TEST(pass({0, 1, 3, 4}) != pass({0, 1, 2, 3, 4}));
}

BOOST_AUTO_TEST_CASE(old_pivots_are_given_up_where_they_are_bad)
{
  // The pivots of the first matrix make the factors of the second grow by 3e5, which KLU itself does not notice.
  dealii::DynamicSparsityPattern pattern(2, 2);
  for (const DofIndex i : {0, 1})
    for (const DofIndex j : {0, 1})
      pattern.add(i, j);
  System system(std::move(pattern), 0, "klu");
  const std::array<DofIndex, 2> dofs{{0, 1}};
  const std::array<double, 2> residual{{-1., -2.}};
  system.set_prescribed({false, false});
  for (const double diagonal : {1., 3e-6, 1., 1e-5, 1e-14, 0., 1e-14})
  {
    const std::array<double, 4> block{{diagonal, 1., 1., 3.}}, other{{1e3 * diagonal, 1., 1., diagonal}};
    for (const auto &matrix : {block, other})
    {
      if (diagonal == 1. && matrix == other)
        continue;
      system.clear(true);
      system.add(dofs.data(), 2, matrix.data(), residual.data());
      BOOST_REQUIRE(system.factorize());
      Vector d(2);
      BOOST_REQUIRE(system.solve(Vector(2), d));
      const double determinant = matrix[0] * matrix[3] - 1.;
      BOOST_TEST(d[0] == (matrix[3] - 2.) / determinant, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(d[1] == (2. * matrix[0] - 1.) / determinant, boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
