#include <deltaform/kinematics/shell_strain.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <random>

// Generalized strains of a shell against finite differences of their definitions.

using namespace deltaform;

namespace
{
  /// Unknowns of two nodes, their shape functions and gradients at one point: the strain as a function of the unknowns.
  struct Point
  {
    std::array<double, 2> shape{{.3, .7}}, gradient{{-1.6, 1.6}};
    double angle = .4, angle_prime = -.7, radius = .8;
    Tensor1 x_prime{{.9, .5}};

    ShellStrain operator()(const std::array<double, 6> &q) const
    {
      Tensor1 derivative = x_prime;
      double rotation = 0., rotation_prime = 0., r = radius;
      for (unsigned int a = 0; a < 2; ++a)
      {
        derivative[0] += gradient[a] * q[3 * a];
        derivative[1] += gradient[a] * q[3 * a + 1];
        r += shape[a] * q[3 * a];
        rotation += shape[a] * q[3 * a + 2];
        rotation_prime += gradient[a] * q[3 * a + 2];
      }
      return {derivative, angle + rotation, angle_prime + rotation_prime, r};
    }
  };

  std::array<double, ShellStrain::size> values(const ShellStrain &strain)
  {
    std::array<double, ShellStrain::size> result;
    result[ShellStrain::stretch] = strain.lambda;
    result[ShellStrain::curvature] = strain.theta_prime;
    result[ShellStrain::radius] = strain.r;
    result[ShellStrain::director_r] = strain.d_r();
    result[ShellStrain::shear] = strain.gamma;
    return result;
  }

  std::array<double, 6> random_unknowns(std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::array<double, 6> q;
    for (auto &value : q)
      value = uniform(generator);
    return q;
  }

  /// n_s times the derivative of strain s with respect to each unknown.
  std::array<double, 6>
  virtual_work(const Point &point, const std::array<double, 6> &q, const std::array<double, ShellStrain::size> &n)
  {
    std::array<double, 6> result{};
    for (unsigned int a = 0; a < 2; ++a)
    {
      const auto b = point(q).derivative(point.shape[a], point.gradient[a]);
      for (unsigned int s = 0; s < ShellStrain::size; ++s)
        for (unsigned int k = 0; k < 3; ++k)
          result[3 * a + k] += n[s] * b[s][k];
    }
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shell_strain)

BOOST_AUTO_TEST_CASE(definitions)
{
  // A meridian that is stretched by 1.2 and turned with its director has no shear.
  const double angle = 2.3;
  const ShellStrain straight(1.2 * Tensor1({std::cos(angle), std::sin(angle)}), angle, .1, 3.);
  BOOST_TEST(std::abs(straight.lambda - 1.2) < 1e-15);
  BOOST_TEST(std::abs(straight.gamma) < 1e-15);
  BOOST_TEST(std::abs(straight.d_r() + std::sin(angle)) < 1e-15);
  // A director that leans back behind its normal by .1: positive shear.
  const ShellStrain sheared(Tensor1({1., 0.}), -.1, 0., 3.);
  BOOST_TEST(std::abs(sheared.lambda - std::cos(.1)) < 1e-15);
  BOOST_TEST(std::abs(sheared.gamma - std::sin(.1)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(rotating_everything_changes_no_strain)
{
  const Tensor1 x({1.1, -.4});
  const ShellStrain before(x, .3, .2, 1.);
  for (const double angle : {.5, -2., 7.})
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const ShellStrain after(Tensor1({c * x[0] - s * x[1], s * x[0] + c * x[1]}), .3 + angle, .2, 1.);
    BOOST_TEST(std::abs(after.lambda - before.lambda) < 1e-14);
    BOOST_TEST(std::abs(after.gamma - before.gamma) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(first_derivatives)
{
  constexpr double h = 1e-5;
  std::mt19937 generator(1);
  const Point point;
  for (unsigned int sample = 0; sample < 50; ++sample)
  {
    const auto q = random_unknowns(generator);
    for (unsigned int a = 0; a < 2; ++a)
    {
      const auto b = point(q).derivative(point.shape[a], point.gradient[a]);
      for (unsigned int k = 0; k < 3; ++k)
      {
        auto plus = q, minus = q;
        plus[3 * a + k] += h;
        minus[3 * a + k] -= h;
        const auto above = values(point(plus)), below = values(point(minus));
        for (unsigned int s = 0; s < ShellStrain::size; ++s)
          BOOST_TEST(std::abs((above[s] - below[s]) / (2. * h) - b[s][k]) < 1e-8);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(second_derivatives)
{
  constexpr double h = 1e-5;
  std::mt19937 generator(2);
  const Point point;
  for (unsigned int sample = 0; sample < 50; ++sample)
  {
    const auto q = random_unknowns(generator), stresses = random_unknowns(generator);
    std::array<double, ShellStrain::size> n;
    std::copy(stresses.begin(), stresses.begin() + ShellStrain::size, n.begin());
    const auto geometric = point(q).geometric(n);
    for (unsigned int j = 0; j < 6; ++j)
    {
      auto plus = q, minus = q;
      plus[j] += h;
      minus[j] -= h;
      const auto above = virtual_work(point, plus, n), below = virtual_work(point, minus, n);
      const unsigned int b = j / 3, l = j % 3;
      for (unsigned int i = 0; i < 6; ++i)
      {
        const unsigned int a = i / 3, k = i % 3;
        double exact = 0.;
        if (k < 2 && l == 2)
          exact = point.gradient[a] * point.shape[b] * geometric.mixed[k];
        else if (k == 2 && l < 2)
          exact = point.gradient[b] * point.shape[a] * geometric.mixed[l];
        else if (k == 2 && l == 2)
          exact = point.shape[a] * point.shape[b] * geometric.rotation;
        BOOST_TEST(std::abs((above[i] - below[i]) / (2. * h) - exact) < 1e-8);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
