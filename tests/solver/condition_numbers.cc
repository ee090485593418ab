// Condition numbers against closed forms, and both ways against each other.
#include "../materials/material_point.h"

#include <deltaform/solver/condition.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

using namespace deltaform;
using deltaform::condition::Matrix;
using deltaform::condition::Method;

namespace
{
  const auto three_digits = boost::test_tools::tolerance(1e-3);

  Matrix sparse(const Eigen::MatrixXd &A)
  {
    return A.sparseView();
  }

  /// A chain of n equal springs between n + 1 free nodes: eigenvalues 2 - 2 cos(k pi / (n + 1)), one of them zero.
  Matrix free_chain(const int n_nodes)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i + 1 < n_nodes; ++i)
      for (const auto &[a, b, value] : {std::array<double, 3>{{0, 0, 1}}, {{1, 1, 1}}, {{0, 1, -1}}, {{1, 0, -1}}})
        entries.emplace_back(i + static_cast<int>(a), i + static_cast<int>(b), value);
    Matrix A(n_nodes, n_nodes);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }

  /// A banded non-symmetric matrix without structure.
  Matrix random_band(const int n, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - 4); j <= std::min(n - 1, i + 4); ++j)
        entries.emplace_back(i, j, (i == j ? 3. : 0.) + uniform(generator) * std::pow(10., 2. * i / n));
    Matrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(condition_numbers)

BOOST_AUTO_TEST_CASE(closed_forms)
{
  for (const auto method : {Method::dense, Method::lanczos})
  {
    BOOST_TEST(condition::number(sparse(Eigen::VectorXd::LinSpaced(40, 1., 1e4).asDiagonal()), method) == 1e4,
               three_digits);
    // [1 a; 0 1]: singular values solve s^2 + 1/s^2 = 2 + a^2; embedded in a unit matrix.
    Eigen::MatrixXd shear = Eigen::MatrixXd::Identity(10, 10);
    shear(0, 1) = 100.;
    const double t = 1. + .5 * 1e4;
    BOOST_TEST(condition::number(sparse(shear), method) == t + std::sqrt(t * t - 1.), three_digits);
    // Hilbert's matrix of order 6: 1.4951e7 (Todd 1954)
    Eigen::MatrixXd hilbert(6, 6);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        hilbert(i, j) = 1. / (i + j + 1);
    BOOST_TEST(condition::number(sparse(hilbert), method) == 1.4951e7, three_digits);
  }
}

BOOST_AUTO_TEST_CASE(dense_and_lanczos_agree)
{
  for (unsigned int seed = 1; seed <= 8; ++seed)
  {
    const Matrix A = random_band(60 + 20 * seed, seed);
    BOOST_TEST(condition::number(A, Method::lanczos) == condition::number(A, Method::dense), three_digits);
  }
}

BOOST_AUTO_TEST_CASE(the_unit_of_stiffness_does_not_matter)
{
  const Matrix A = random_band(160, 5);
  for (const auto method : {Method::dense, Method::lanczos})
    for (const double unit : {1e-12, 1e12})
      BOOST_TEST(condition::number(unit * A, method) == condition::number(A, method),
                 boost::test_tools::tolerance(1e-5));
  // Too small for a Krylov space.
  for (const int n : {1, 2})
    BOOST_TEST(condition::number(1e12 * random_band(n, 1), Method::lanczos) ==
                 condition::number(random_band(n, 1), Method::dense),
               three_digits);
}

BOOST_AUTO_TEST_CASE(singular)
{
  for (const auto method : {Method::dense, Method::lanczos})
  {
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(5, 5);
    A(3, 3) = 0.;
    BOOST_TEST(condition::number(sparse(A), method) > 1e300);
    // Singular only to working precision: a chain of springs that nothing holds.
    BOOST_TEST(condition::number(free_chain(400), method) > 1e12);
    // The square of the inverse overflows.
    A(3, 3) = 1e-200;
    BOOST_TEST(condition::number(sparse(A), method) > 1e199);
  }
}

BOOST_AUTO_TEST_CASE(complement_of_a_rigid_mode)
{
  const int n = 80;
  const Matrix A = free_chain(n);
  const auto mode = [](const int k) { return 2. - 2. * std::cos(k * M_PI / n); };
  const Eigen::MatrixXd rigid = Eigen::VectorXd::Constant(n, 1. / std::sqrt(n));
  for (const auto method : {Method::dense, Method::lanczos})
    BOOST_TEST(condition::number_on_complement(A, rigid, method) == mode(n - 1) / mode(1), three_digits);
}

BOOST_AUTO_TEST_CASE(frames_and_scaling)
{
  // A stiff spring along an inclined direction: without the frame the scaling cannot remove it.
  const double angle = .6;
  const Tensor1 normal({std::cos(angle), std::sin(angle)});
  Matrix A = free_chain(30);
  Eigen::MatrixXd dense_A = A;
  dense_A += .1 * Eigen::MatrixXd::Identity(30, 30);
  const auto with = [&](const double epsilon) {
    Eigen::MatrixXd B = dense_A;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        B(10 + a, 10 + b) += epsilon * normal[a] * normal[b];
    return sparse(B);
  };
  const std::vector<condition::Frame> frames{{10, 11, normal}};
  const double soft = condition::number(condition::scale_in_frames(with(1e2), frames)),
               stiff = condition::number(condition::scale_in_frames(with(1e9), frames));
  BOOST_TEST(stiff == soft, boost::test_tools::tolerance(.05));
  BOOST_TEST(condition::number(with(1e9)) > 1e6 * condition::number(with(1e2)));
  BOOST_TEST(condition::number(condition::scale_in_frames(with(1e9), {})) > 1e2 * stiff);
  // A unit diagonal.
  const Matrix scaled = condition::scale_in_frames(with(1e9), frames);
  for (int i = 0; i < 30; ++i)
    BOOST_TEST(scaled.coeff(i, i) == 1., boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_axes_do_not_matter)
{
  // Two nodes described in axes of their own, turned by different angles, normals with them: a not symmetric matrix.
  const int n = 60;
  const Matrix A = random_band(n, 3);
  Matrix turned = A;
  const auto turn = [&](const int r, const int z, const double angle) {
    Eigen::MatrixXd T = Eigen::MatrixXd::Identity(n, n);
    T(r, r) = T(z, z) = std::cos(angle);
    T(r, z) = -std::sin(angle);
    T(z, r) = std::sin(angle);
    turned = sparse(T.transpose() * Eigen::MatrixXd(turned) * T);
  };
  const auto normal = [](const double angle) { return Tensor1({std::cos(angle), std::sin(angle)}); };
  turn(7, 8, .9);
  turn(30, 33, -2.);
  const std::vector<condition::Frame> frames{{7, 8, normal(.3)}, {30, 33, normal(1.1)}},
    turned_frames{{7, 8, normal(.3 - .9)}, {30, 33, normal(1.1 + 2.)}};
  for (const auto method : {Method::dense, Method::lanczos})
  {
    const auto close = boost::test_tools::tolerance(method == Method::dense ? 1e-10 : 1e-5);
    BOOST_TEST(condition::number(turned, method) == condition::number(A, method), close);
    BOOST_TEST(condition::number(condition::scale_in_frames(turned, turned_frames), method) ==
                 condition::number(condition::scale_in_frames(A, frames), method),
               close);
  }
  // Scaled in the wrong axes it is another number.
  const double right = condition::number(condition::scale_in_frames(A, frames));
  BOOST_TEST(std::abs(condition::number(condition::scale_in_frames(turned, frames)) / right - 1.) > 1e-3);
}

BOOST_AUTO_TEST_CASE(lost_digits)
{
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(10, 1., 2.);
  BOOST_TEST(condition::digits_lost(sparse(Eigen::MatrixXd::Identity(10, 10)), x) < .5);
  // A scaling by powers of ten makes kappa huge and loses nothing.
  const Eigen::VectorXd powers =
    Eigen::VectorXd::LinSpaced(10, 0., 9.).unaryExpr([](double e) { return std::pow(10., e); });
  const Matrix harmless = sparse(powers.asDiagonal());
  BOOST_TEST(condition::number(harmless) == 1e9, three_digits);
  BOOST_TEST(condition::digits_lost(harmless, x) < 1.);
  // Hilbert's matrix of order 10 (kappa 1.6e13) loses most of them.
  Eigen::MatrixXd hilbert(10, 10);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      hilbert(i, j) = 1. / (i + j + 1);
  const double lost = condition::digits_lost(sparse(hilbert), x);
  BOOST_TEST(lost > 8.);
  BOOST_TEST(lost < 14.);
}

BOOST_AUTO_TEST_SUITE_END()
