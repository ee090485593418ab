// Balanced states that a solve comes back to.
#include <deltaform/increment/returns.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  const std::vector<double> scale{1., 10.};

  Vector at(const double u, const double rotation)
  {
    Vector q(2);
    q[0] = u;
    q[1] = rotation;
    return q;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(returns)

BOOST_AUTO_TEST_CASE(a_state_is_met_again_after_others)
{
  Returns states;
  BOOST_TEST(!states.come(at(1., 0.), scale, 1e-3));
  states.leave();
  BOOST_TEST(states.come(at(1. + 5e-4, 0.), scale, 1e-3));
}

BOOST_AUTO_TEST_CASE(small_steps_at_balance_lead_nowhere_and_do_not_count)
{
  // They are small because they are damped, or cut: the next may go on.
  Returns states;
  for (unsigned int k = 0; k < 5; ++k)
    BOOST_TEST(!states.come(at(1. + 1e-4 * k, 0.), scale, 1e-3));
}

BOOST_AUTO_TEST_CASE(every_unknown_has_to_be_the_same)
{
  Returns states;
  states.come(at(1., .1), scale, 1e-3);
  states.leave();
  BOOST_TEST(!states.come(at(1., .1002), scale, 1e-3)); // 2e-3, scaled
  states.leave();
  BOOST_TEST(!states.come(at(1.002, .1), scale, 1e-3));
}

BOOST_AUTO_TEST_CASE(a_circle_may_lead_through_some_states)
{
  Returns states;
  for (const double u : {1., 2., 3., 4.})
  {
    BOOST_TEST(!states.come(at(u, 0.), scale, 1e-3));
    states.leave();
  }
  BOOST_TEST(states.come(at(1., 0.), scale, 1e-3));
  states.leave();
  BOOST_TEST(states.come(at(4., 0.), scale, 1e-3));
}

BOOST_AUTO_TEST_CASE(states_of_long_ago_are_forgotten)
{
  Returns states;
  for (const double u : {1., 2., 3., 4., 5.})
  {
    states.come(at(u, 0.), scale, 1e-3);
    states.leave();
  }
  BOOST_TEST(!states.come(at(1., 0.), scale, 1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
