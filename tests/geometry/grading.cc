#include <deltaform/geometry/grading.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(grading)

// 1/size = exp(-c t): the ends are -ln(1 - (1 - exp(-c)) k/n)/c. The largest element is 1000 times the smallest.
BOOST_AUTO_TEST_CASE(exponential_sizes_have_their_closed_form)
{
  const double c = std::log(1000.);
  const unsigned int n = 20;
  const auto ends = element_ends([c](const double t) { return std::exp(c * t); }, 0., 1., n);
  BOOST_REQUIRE_EQUAL(ends.size(), n + 1);
  for (unsigned int k = 0; k <= n; ++k)
    BOOST_TEST(ends[k] == -std::log(1. - (1. - std::exp(-c)) * k / n) / c, boost::test_tools::tolerance(1e-8));
}

// A size that grows in proportion to the distance from a small place: a constant ratio of neighbours.
BOOST_AUTO_TEST_CASE(a_linear_size_gives_a_geometric_series)
{
  const auto ends = element_ends([](const double t) { return t + .001; }, 0., 1., 30);
  const double ratio = std::pow(1.001 / .001, 1. / 30);
  for (unsigned int k = 0; k + 2 < ends.size(); ++k)
    BOOST_TEST((ends[k + 2] - ends[k + 1]) / (ends[k + 1] - ends[k]) == ratio, boost::test_tools::tolerance(1e-6));
}

// Sizes 1 and 4 left and right of a jump at .3: densities .3 and .7/4, of 19 elements 12 and 7.
BOOST_AUTO_TEST_CASE(a_jump_is_met)
{
  const auto ends = element_ends([](const double t) { return t < .3 ? 1. : 4.; }, 0., 1., 19);
  BOOST_TEST(ends[12] == .3, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(ends[1] - ends[0] == .025, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(ends[19] - ends[18] == .1, boost::test_tools::tolerance(1e-4));
}

// Elements as long as a hundred million times the round-off of their ends. Of size .1 + t: t = .1 (11^(i/n) - 1).
BOOST_AUTO_TEST_CASE(a_million_elements)
{
  constexpr unsigned int n = 1000000;
  const auto ends = element_ends([](const double t) { return .1 + t; }, 0., 1., n);
  for (const unsigned int i : {1u, 1000u, n / 2, n - 1})
    BOOST_TEST(ends[i] == .1 * (std::pow(11., static_cast<double>(i) / n) - 1.), boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_part_of_the_line_has_its_share_of_the_elements)
{
  const auto size = [](const double t) { return 1. + t; };
  BOOST_TEST(element_density(size, .25, .75) == std::log(1.75 / 1.25), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
