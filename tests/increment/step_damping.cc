// The radius that keeps steps short along what nothing resists.
#include <deltaform/increment/step_damping.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  const auto near = boost::test_tools::tolerance(1e-12);

  /// One that has seen two steps of length 1, of which @p taken was taken each.
  StepDamping after_two_steps(const double taken)
  {
    StepDamping damping;
    for (unsigned int k = 0; k < 2; ++k)
      damping.judge(1e-4, taken, 1.);
    return damping;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(step_damping)

BOOST_AUTO_TEST_CASE(there_is_none_until_two_steps_in_a_row_are_cut)
{
  StepDamping damping;
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  damping.judge(1e-4, .6, 3.); // most of it was taken
  damping.judge(1e-4, 1., 3.);
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  // A single one may be where metal begins to flow.
  damping.judge(1e-4, .1, 3.);
  damping.judge(1e-4, 1., 3.);
  damping.judge(1e-4, .1, 3.);
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  damping.judge(1e-4, .1, 3.);
  BOOST_TEST(damping.radius(1e-4) == .3, near);
}

BOOST_AUTO_TEST_CASE(it_is_what_was_taken_of_the_last_of_them)
{
  StepDamping damping = after_two_steps(.1);
  BOOST_TEST(damping.radius(2e-5) == .1, near);
  damping.judge(1e-4, .02, 2.);
  BOOST_TEST(damping.radius(2e-5) == .04, near);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_long_against_the_increment_is_too_long)
{
  StepDamping damping;
  BOOST_TEST(!damping.bound(1e-4, .49, 10.));
  BOOST_TEST(!damping.bound(2e-3, 5., 10.)); // far from equilibrium
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  BOOST_TEST(damping.bound(1e-4, .51, 10.));
  BOOST_TEST(damping.radius(1e-4) == .5, near);
  // What is damped is bounded.
  BOOST_TEST(!damping.bound(1e-4, .51, 1.));
  BOOST_TEST(damping.radius(1e-4) == .5, near);
}

BOOST_AUTO_TEST_CASE(far_from_equilibrium_it_neither_acts_nor_learns)
{
  StepDamping damping;
  for (unsigned int k = 0; k < 5; ++k)
    damping.judge(2e-3, .1, 3.);
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  damping = after_two_steps(.1);
  BOOST_TEST(std::isinf(damping.radius(2e-3)));
  BOOST_TEST(damping.radius(1e-4) == .1, near);
}

BOOST_AUTO_TEST_CASE(it_grows_with_steps_that_need_all_of_it)
{
  StepDamping damping = after_two_steps(.1);
  damping.judge(1e-4, 1., .04); // shorter by itself
  BOOST_TEST(damping.radius(1e-4) == .1, near);
  damping.judge(1e-4, .4, .1); // one that is cut
  BOOST_TEST(damping.radius(1e-4) == .1, near);
  damping.judge(1e-4, .7, .08);
  BOOST_TEST(damping.radius(1e-4) == .4, near);
  // Balanced, but not at the end of a damped step.
  damping.loosen();
  BOOST_TEST(damping.radius(1e-4) == 1.6, near);
}

BOOST_AUTO_TEST_CASE(it_shrinks_where_sets_lead_to_each_other)
{
  StepDamping damping;
  BOOST_TEST(!damping.shorten(2e-3, 3.)); // far from equilibrium
  BOOST_TEST(std::isinf(damping.radius(1e-4)));
  BOOST_TEST(damping.shorten(1e-4, 3.));
  BOOST_TEST(damping.radius(1e-4) == 3., near);
  BOOST_TEST(damping.shorten(1e-4, 1.));
  BOOST_TEST(damping.radius(1e-4) == .75, near);
  BOOST_TEST(damping.shorten(1e-4, .1));
  BOOST_TEST(damping.radius(1e-4) == .1, near);
}

BOOST_AUTO_TEST_SUITE_END()
