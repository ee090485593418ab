#include <deltaform/parameters/skipped_time.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(skipped_time)

BOOST_AUTO_TEST_CASE(functions_go_on_from_where_they_were)
{
  const TimeFunction motion("10*t", {});
  SkippedTime skipped;
  BOOST_TEST(skipped.value(motion, .7) == 7.);
  skipped.add(.4, 1.); // a stage to t = 1 has ended at .4
  BOOST_TEST(skipped.value(motion, .4) == 4.);
  BOOST_TEST(skipped.value(motion, 1.) == 4.);
  BOOST_TEST(skipped.value(motion, 1.5) == 9.);
  skipped.add(1.5, 2.);
  BOOST_TEST(skipped.value(motion, 2.) == 9.);
  BOOST_TEST(skipped.value(motion, 2.25) == 11.5);
}

BOOST_AUTO_TEST_SUITE_END()
