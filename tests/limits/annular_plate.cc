// Buckling of rings against load factors of an independent program and closed forms.
#include <deltaform/limits/annular_plate.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  /// A ring from @p inner to 1 of unit stiffness.
  template <typename Forces>
  std::vector<RingPoint> ring(const double inner, const Forces &forces)
  {
    constexpr unsigned int n = 400;
    std::vector<RingPoint> result;
    for (unsigned int i = 0; i <= n; ++i)
    {
      const double r = inner + (1. - inner) * i / n;
      const auto [radial, hoop] = forces(r);
      result.push_back({r, radial, hoop, 1.});
    }
    return result;
  }

  /// A flange of a rigid-plastic metal (Tresca) of unit flow stress that is drawn in.
  std::pair<double, double> drawn_in(const double r)
  {
    return {-std::log(r), -(1. + std::log(r))};
  }
} // namespace

BOOST_AUTO_TEST_SUITE(annular_plate)

BOOST_AUTO_TEST_CASE(a_perfectly_plastic_flange)
{
  // S t w^2/D for the width w, hinged at the die, nu = .3.
  const double inner[] = {.4, .5, .6, .7, .8}, factor[] = {7.2015, 6.7495, 6.5638, 6.2850, 6.0320};
  const unsigned int waves[] = {2, 3, 3, 4, 6};
  for (unsigned int i = 0; i < 5; ++i)
    BOOST_TEST_CONTEXT("b/a = " << inner[i])
    {
      const Wrinkles found = wrinkle(ring(inner[i], drawn_in), .3, 1.);
      BOOST_TEST(found.waves == waves[i]);
      BOOST_TEST(std::abs(found.factor * std::pow(1. - inner[i], 2) - factor[i]) < 1e-4 * factor[i]);
    }
}

BOOST_AUTO_TEST_CASE(forces_and_factor_are_inverse)
{
  const auto threefold = [](const double r) { return std::make_pair(-3. * std::log(r), -3. * (1. + std::log(r))); };
  const Wrinkles one = wrinkle(ring(.6, drawn_in), .3, 1.), three = wrinkle(ring(.6, threefold), .3, 1.);
  BOOST_TEST(std::abs(3. * three.factor - one.factor) < 1e-9 * one.factor);
  BOOST_TEST(three.waves == one.waves);
}

BOOST_AUTO_TEST_CASE(a_narrow_ring_is_a_strip)
{
  // One edge hinged, the other free, compressed along both by N: N = D (m^2 + 2 (1 - nu) 3/(2 w^2) ...) has the limit
  // of long waves D 6 (1 - nu)/w^2 (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, section 9.4).
  const Wrinkles found = wrinkle(ring(.99, [](double) { return std::make_pair(0., -1.); }), .3, 1.);
  BOOST_TEST(std::abs(found.factor * 1e-4 - 6. * .7) < .01 * 6. * .7);
}

BOOST_AUTO_TEST_CASE(tension_does_not_wrinkle)
{
  const Wrinkles found = wrinkle(ring(.5, [](double) { return std::make_pair(1., 1.); }), .3, 1.);
  BOOST_TEST(found.waves == 0u);
  BOOST_TEST(!std::isfinite(found.factor));
  BOOST_TEST(found.pressure == 0.);
}

BOOST_AUTO_TEST_CASE(a_holder_is_needed_beyond_the_factor)
{
  const auto times = [](const double size) {
    return [size](const double r) { return std::make_pair(-size * std::log(r), -size * (1. + std::log(r))); };
  };
  const double factor = wrinkle(ring(.6, drawn_in), .3, .1).factor;
  BOOST_TEST(wrinkle(ring(.6, times(.99 * factor)), .3, .1).pressure == 0.);
  const double once = wrinkle(ring(.6, times(2. * factor)), .3, .1).pressure;
  BOOST_TEST(once > 0.);
  BOOST_TEST(std::abs(wrinkle(ring(.6, times(2. * factor)), .3, .3).pressure - 3. * once) < 1e-9 * once);
}

BOOST_AUTO_TEST_SUITE_END()
