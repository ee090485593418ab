// The turns of a quantity that goes up and down.
#include <deltaform/conditions/turning_points.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  TurningPoints of(const std::vector<double> &values)
  {
    TurningPoints result;
    for (const double value : values)
      result.add(value);
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(turning_points)

BOOST_AUTO_TEST_CASE(neither_the_first_way_nor_the_last_is_a_swing)
{
  BOOST_TEST(of({}).swings(0.).empty());
  BOOST_TEST(of({1., 2., 3.}).swings(0.).empty());
  BOOST_TEST(of({1., 3., 2.}).swings(0.).empty());
  const std::vector<double> one{2.};
  BOOST_TEST(of({1., 2., 4., 3., 2., 5.}).swings(0.) == one, boost::test_tools::per_element());
  BOOST_TEST(of({-1., -2., -4., -3., -2., -5.}).swings(2.) == one, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(small_swings_are_parts_of_large_ones)
{
  const TurningPoints points = of({0., 10., 9., 10.5, 4., 5., 3., 8., 7.9, 9., 0.});
  const std::vector<double> large{7.5, 6.}, all{1., 1.5, 6.5, 1., 2., 6.};
  BOOST_TEST(points.swings(2.) == large, boost::test_tools::per_element());
  BOOST_TEST(points.swings(0.) == all, boost::test_tools::per_element());
  BOOST_TEST(points.swings(7.).empty());
}

BOOST_AUTO_TEST_CASE(waves_are_counted_however_fine_the_steps)
{
  for (const unsigned int steps : {10, 1000})
  {
    TurningPoints points;
    for (unsigned int i = 0; i <= 8 * steps; ++i)
      points.add(5. + std::sin(2. * std::acos(-1.) * i / steps));
    const std::vector<double> swings = points.swings(1.8);
    BOOST_TEST(swings.size() == 13u); // of 16 turns, but from the first and to the last
    for (const double swing : swings)
      BOOST_TEST(swing == 2., boost::test_tools::tolerance(.06));
  }
}

BOOST_AUTO_TEST_SUITE_END()
