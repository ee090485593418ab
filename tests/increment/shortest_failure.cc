#include <deltaform/increment/shortest_failure.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(shortest_failure)

BOOST_AUTO_TEST_CASE(the_first_of_the_shortest_attempts_is_told)
{
  ShortestFailure failure;
  failure.add({Rejected::Kind::not_solved, "half"}, .5);
  BOOST_TEST(failure.reason().sentence == "half");
  failure.add({Rejected::Kind::too_large, "shortest"}, .1);
  failure.add({Rejected::Kind::not_solved, "again"}, .1);
  failure.add({Rejected::Kind::promise_broken, "longer"}, 1.);
  BOOST_TEST(failure.reason().sentence == "shortest");
  BOOST_TEST((failure.reason().kind == Rejected::Kind::too_large));
}

BOOST_AUTO_TEST_SUITE_END()
