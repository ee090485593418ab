// Tensor logarithm against Eigen's eigenvalues, its rate against differences, its inverse.
#include <deltaform/kinematics/logarithmic_strain.h>

#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>

#include <random>

using namespace deltaform;

namespace
{
  constexpr double root_2 = 1.41421356237309504880;

  AxialTensor tensor(const Eigen::Matrix2d &b, const double zz)
  {
    return {b(0, 0), b(1, 1), zz, .5 * (b(0, 1) + b(1, 0))};
  }

  /// By eigenvalues, which share no line with the closed form.
  Eigen::Matrix2d logarithm(const Eigen::Matrix2d &b)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(b);
    return solver.eigenvectors() * (.5 * solver.eigenvalues().array().log()).matrix().asDiagonal() *
           solver.eigenvectors().transpose();
  }

  /// Positive definite, with eigenvalues that differ by about @p spread.
  Eigen::Matrix2d random_tensor(std::mt19937 &generator, const double spread)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const double angle = 3. * uniform(generator), size = std::exp(uniform(generator));
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    return R * Eigen::Vector2d(size * std::exp(spread), size * std::exp(-spread)).asDiagonal() * R.transpose();
  }

  const double spreads[] = {0., 1e-12, 1e-8, 1e-4, .05, .0999, .1001, .11, .5, 2.};
} // namespace

BOOST_AUTO_TEST_SUITE(logarithmic_strain)

BOOST_AUTO_TEST_CASE(agrees_with_the_eigenvalues)
{
  std::mt19937 generator(1);
  for (const double spread : spreads)
    for (unsigned int k = 0; k < 20; ++k)
    {
      const Eigen::Matrix2d b = random_tensor(generator, spread), expected = logarithm(b);
      const auto e = LogarithmicStrain::strain(tensor(b, 1.7));
      BOOST_TEST(std::abs(e[0] - expected(0, 0)) < 2e-14);
      BOOST_TEST(std::abs(e[1] - expected(1, 1)) < 2e-14);
      BOOST_TEST(std::abs(e[3] - root_2 * expected(0, 1)) < 2e-14);
      BOOST_TEST(std::abs(e[2] - .5 * std::log(1.7)) < 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(inverse_of_the_logarithm)
{
  std::mt19937 generator(2);
  for (const double spread : spreads)
    for (unsigned int k = 0; k < 20; ++k)
    {
      const AxialTensor b = tensor(random_tensor(generator, spread), .4);
      const AxialTensor back = LogarithmicStrain::inverse(LogarithmicStrain::strain(b));
      const double size = b.xx + b.yy;
      BOOST_TEST(std::abs(back.xx - b.xx) < 1e-13 * size);
      BOOST_TEST(std::abs(back.yy - b.yy) < 1e-13 * size);
      BOOST_TEST(std::abs(back.xy - b.xy) < 1e-13 * size);
      BOOST_TEST(std::abs(back.zz - b.zz) < 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(rate_against_differences)
{
  std::mt19937 generator(3);
  for (const double spread : spreads)
    for (unsigned int k = 0; k < 5; ++k)
    {
      const Eigen::Matrix2d b = random_tensor(generator, spread);
      const auto rate = LogarithmicStrain::rate(tensor(b, 1.3));
      for (unsigned int c = 0; c < 5; ++c)
      {
        const auto at = [&](const double step) {
          Eigen::Matrix2d f = Eigen::Matrix2d::Identity();
          double hoop = 1.;
          if (c < 4)
            f(c / 2, c % 2) += step;
          else
            hoop += step;
          return LogarithmicStrain::strain(tensor(f * b * f.transpose(), hoop * hoop * 1.3));
        };
        const double h = 1e-3;
        const auto plus = at(h), minus = at(-h), plus_half = at(.5 * h), minus_half = at(-.5 * h);
        for (unsigned int i = 0; i < 4; ++i)
        {
          const double coarse = (plus[i] - minus[i]) / (2. * h), fine = (plus_half[i] - minus_half[i]) / h;
          BOOST_TEST(std::abs((4. * fine - coarse) / 3. - rate[i][c]) < 1e-9);
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(a_rotation_turns_the_strain)
{
  // d e = W e - e W for a spin W, whatever b.
  std::mt19937 generator(4);
  for (const double spread : spreads)
  {
    const AxialTensor b = tensor(random_tensor(generator, spread), 1.);
    const auto e = LogarithmicStrain::strain(b);
    const auto rate = LogarithmicStrain::rate(b);
    const auto turn = [&](const unsigned int i) { return rate[i][2] - rate[i][1]; };
    BOOST_TEST(std::abs(turn(0) + root_2 * e[3]) < 1e-13);
    BOOST_TEST(std::abs(turn(1) - root_2 * e[3]) < 1e-13);
    BOOST_TEST(std::abs(turn(3) - root_2 * (e[0] - e[1])) < 1e-13);
  }
}

BOOST_AUTO_TEST_SUITE_END()
