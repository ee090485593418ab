#include <deltaform/materials/point_history.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(point_history)

BOOST_AUTO_TEST_CASE(commit_and_rollback)
{
  PointHistory history(3, 2);
  BOOST_TEST(history.committed(2)[1] == 0.);
  history.trial(2)[1] = 7.;
  BOOST_TEST(history.committed(2)[1] == 0.);
  history.commit();
  BOOST_TEST(history.committed(2)[1] == 7.);
  BOOST_TEST(history.committed(0)[5] == 7.); // points follow each other
  history.trial(2)[1] = 9.;
  history.rollback();
  BOOST_TEST(history.committed(2)[1] == 7.);
  BOOST_TEST(history.trial(2)[1] == 7.);
}

BOOST_AUTO_TEST_CASE(is_part_of_a_state)
{
  PointHistory history(2, 5), other(2, 5);
  history.trial(1)[4] = .1;
  history.commit();
  history.trial(0)[0] = .3;
  KeyedArrays state;
  history.put(state, "history");
  other.take(state, "history");
  BOOST_TEST(other.committed(1)[4] == .1);
  BOOST_TEST(other.trial(0)[0] == .3);
}

BOOST_AUTO_TEST_CASE(nothing_to_remember)
{
  PointHistory history(10, 0);
  history.commit();
  history.rollback();
  BOOST_TEST(history.committed(9) == history.committed(0));
}

BOOST_AUTO_TEST_SUITE_END()
