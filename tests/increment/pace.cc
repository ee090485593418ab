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
  // One increment in ten snaps: 15 iterations on average.
  Pace pace(0.);
  for (unsigned int i = 1; i <= Pace::window; ++i)
  {
    BOOST_TEST(pace.iterations_left(1.) == 0.);
    pace.accept(1e-4 * i, i % 10 == 0 ? 105 : 5);
  }
  BOOST_TEST(pace.iterations_left(1.) == 9000. * 15., boost::test_tools::tolerance(1e-12));
  // Each does: the last 191 took 20 055 iterations. The pace of the others no longer counts.
  for (unsigned int i = 1; i <= 200; ++i)
    pace.accept(.1 + 1e-5 * i, 105);
  BOOST_TEST(pace.iterations_left(1.) == .898 / 1e-5 * 105., boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_effort_tells_before_so_many_increments_do)
{
  Pace pace(0.);
  for (unsigned int i = 1; i <= 19; ++i)
  {
    pace.accept(1e-5 * i, 1050);
    BOOST_TEST(pace.never_ends(1., 400).empty());
  }
  pace.accept(20e-5, 1050);
  BOOST_TEST(pace.iterations_left(1.) == (1. - 20e-5) / 1e-5 * 1050., boost::test_tools::tolerance(1e-9));
  const std::string why = pace.never_ends(1., 400);
  BOOST_TEST(why.find("at the pace of the last 20000 Newton iterations the stage takes 1.05e8 more") == 0u, why);
  BOOST_TEST(pace.never_ends(20e-5 + 1904. * 1e-5, 400).empty()); // 1 999 200 iterations
  BOOST_TEST(!pace.never_ends(20e-5 + 1905. * 1e-5, 400).empty());
  BOOST_TEST(pace.never_ends(20e-5 + 1905. * 1e-5, 52000).empty()); // so many increments are allowed, of forty each
}

BOOST_AUTO_TEST_SUITE_END()
