#include <deltaform/increment/stagnation.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  /// Residuals from @p first on that fall by @p ratio in an iteration.
  std::vector<double> falling(const double first, const double ratio, const unsigned int n_iterations)
  {
    std::vector<double> residuals;
    for (unsigned int i = 0; i <= n_iterations; ++i)
      residuals.push_back(first * std::pow(ratio, i));
    return residuals;
  }

  constexpr Stagnation rule{8, 20, 40, 1e-3, 1e-5};
} // namespace

BOOST_AUTO_TEST_SUITE(stagnation)

BOOST_AUTO_TEST_CASE(far_from_equilibrium_they_have_to_halve)
{
  // In eight iterations by .95^8 = .66, by .9^8 = .43.
  BOOST_TEST(rule.reached(falling(.5, .95, 8)));
  BOOST_TEST(!rule.reached(falling(.5, .9, 8)));
  BOOST_TEST(!rule.reached(falling(.5, 1., 7))); // too few to tell
  // It is the smallest ones that count, in any order.
  BOOST_TEST(!rule.reached({1., .1, .8, .7, .04, .6, .9, .5, .8, .9}));
  BOOST_TEST(rule.reached({1., .1, .8, .7, .06, .6, .9, .5, .8, .9}));
}

BOOST_AUTO_TEST_CASE(close_to_it_they_have_to_arrive)
{
  // From 5e-4 after eight iterations, 32 are left: by .9 each they end at 7e-6, by .92 at 1.8e-5.
  BOOST_TEST(!rule.reached(falling(5e-4, .9, 8)));
  BOOST_TEST(rule.reached(falling(5e-4, .92, 8)));
  // The same after thirty.
  BOOST_TEST(rule.reached(falling(5e-4, .95, 30)));
  // One that is good enough has arrived, whatever comes after it.
  BOOST_TEST(!rule.reached({5e-4, 4e-4, 3e-4, 9e-6, 3e-4, 3e-4, 3e-4, 3e-4, 3e-4, 3e-4}));
}

BOOST_AUTO_TEST_CASE(patience_has_a_longer_window)
{
  BOOST_TEST(rule.reached(falling(.5, .99, 12)));
  BOOST_TEST(!rule.reached(falling(.5, .99, 19), true));
  BOOST_TEST(rule.reached(falling(.5, .99, 20), true)); // .82
  BOOST_TEST(!rule.reached(falling(.5, .95, 20), true)); // .36
}

BOOST_AUTO_TEST_SUITE_END()
