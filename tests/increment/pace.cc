#include <deltaform/increment/pace.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(pace)

BOOST_AUTO_TEST_CASE(it_is_told_by_the_last_increments_only)
{
  Pace pace(1.);
  for (unsigned int i = 1; i < Pace::window; ++i)
  {
    pace.accept(1. + double(i) / Pace::window, 5);
    BOOST_TEST(pace.left(3.) == 0.); // too few to tell
  }
  pace.accept(2., 5);
  BOOST_TEST(pace.left(3.) == Pace::window, boost::test_tools::tolerance(1e-12));
  for (unsigned int i = 1; i <= Pace::window; ++i)
    pace.accept(2. + 1e-6 * i, 5);
  BOOST_TEST(pace.left(3.) == 1e6 - Pace::window, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_stage_that_never_ends_says_so)
{
  Pace pace(0.);
  for (unsigned int i = 1; i <= Pace::window; ++i)
    pace.accept(1e-6 * i, 5);
  BOOST_TEST(pace.never_ends(1., 400).find("at the pace of the last 1000 increments the stage takes ") == 0u);
  BOOST_TEST(!pace.never_ends(.0511, 400).empty());
  BOOST_TEST(pace.never_ends(.0509, 400).empty()); // 49 900 more
  BOOST_TEST(!pace.never_ends(1., 998000).empty());
  BOOST_TEST(pace.never_ends(1., 999001).empty()); // so many are allowed
}

BOOST_AUTO_TEST_CASE(nothing_is_left_at_the_end)
{
  Pace pace(0.);
  for (unsigned int i = 1; i <= Pace::window; ++i)
    pace.accept(double(i) / Pace::window, 5);
  BOOST_TEST(pace.left(1.) == 0.);
  BOOST_TEST(pace.iterations_left(1.) == 0.);
}

BOOST_AUTO_TEST_CASE(iterations_count_as_well)
{
  // One increment in ten snaps.
  Pace pace(0.);
  for (unsigned int i = 1; i <= Pace::window; ++i)
  {
    BOOST_TEST(pace.iterations_left(1.) == 0.);
    pace.accept(1e-4 * i, i % 10 == 0 ? 105 : 5);
  }
  BOOST_TEST(pace.iterations_left(1.) == 9000. * 15., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(pace.never_ends(1., 400).empty());
  BOOST_TEST(pace.never_ends(3.4, 400).empty()); // 33 000 increments, 495 000 iterations
  const std::string why = pace.never_ends(3.5, 400);
  BOOST_TEST(why.find("takes 34000 more, with 510000 Newton iterations") != std::string::npos, why);
  BOOST_TEST(pace.never_ends(3.5, 52000).empty()); // so many are allowed, of ten iterations each
}

BOOST_AUTO_TEST_SUITE_END()
