// The stiffness that keeps steps short along what nothing resists.
#include <deltaform/increment/step_damping.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  /// One that has seen two steps, of which @p taken was taken each.
  StepDamping after_two_steps(const double taken)
  {
    StepDamping damping;
    for (unsigned int k = 0; k < 2; ++k)
      damping.judge(1e-4, 9e-5, taken, 1.);
    return damping;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(step_damping)

BOOST_AUTO_TEST_CASE(there_is_none_until_two_steps_in_a_row_are_cut)
{
  StepDamping damping;
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
  damping.judge(1e-4, 2e-4, .6, 3.); // it grew, but most of the step was taken
  damping.judge(1e-4, 5e-5, 1., 3.);
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
  // A single one may be where metal begins to flow.
  damping.judge(1e-4, 9e-5, .1, 3.);
  damping.judge(1e-4, 5e-5, 1., 3.);
  damping.judge(1e-4, 9e-5, .1, 3.);
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
  damping.judge(1e-4, 9e-5, .1, 3.);
  BOOST_TEST(damping.stiffness(1e-4, 50.) > 0.);
}

BOOST_AUTO_TEST_CASE(a_step_that_nothing_resists_comes_to_the_part_that_was_taken)
{
  StepDamping damping = after_two_steps(.1);
  const double force = 2e-5 * 50.; // |R|
  BOOST_TEST(force / damping.stiffness(2e-5, 50.) == .1, boost::test_tools::tolerance(1e-12));
  // Of the last one, if another follows.
  damping.judge(1e-4, 9e-5, .02, 2.);
  BOOST_TEST(force / damping.stiffness(2e-5, 50.) == .04, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_step_that_is_long_against_the_increment_is_too_long)
{
  StepDamping damping;
  BOOST_TEST(!damping.bound(1e-4, .49, 10.));
  BOOST_TEST(!damping.bound(2e-3, 5., 10.)); // far from equilibrium
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
  BOOST_TEST(damping.bound(1e-4, .51, 10.));
  BOOST_TEST(1e-4 * 50. / damping.stiffness(1e-4, 50.) == .5, boost::test_tools::tolerance(1e-12));
  // What is damped is bounded.
  BOOST_TEST(!damping.bound(1e-4, .51, 1.));
  BOOST_TEST(1e-4 * 50. / damping.stiffness(1e-4, 50.) == .5, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(far_from_equilibrium_it_neither_acts_nor_learns)
{
  StepDamping damping;
  for (unsigned int k = 0; k < 5; ++k)
    damping.judge(2e-3, 1e-3, .1, 3.);
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
  damping = after_two_steps(.1);
  BOOST_TEST(damping.stiffness(2e-3, 50.) == 0.);
  BOOST_TEST(damping.stiffness(1e-4, 50.) > 0.);
}

BOOST_AUTO_TEST_CASE(it_fades_with_steps_that_are_taken)
{
  StepDamping damping = after_two_steps(.1);
  const double first = damping.stiffness(1e-4, 50.);
  damping.judge(1e-4, 1.1e-4, .7, .1); // no better: as it was
  BOOST_TEST(damping.stiffness(1e-4, 50.) == first);
  damping.judge(1e-4, 9e-5, 1., .1);
  BOOST_TEST(damping.stiffness(1e-4, 50.) == first / 4., boost::test_tools::tolerance(1e-12));
  // Once the radius is a thousand times the step nothing is left of it.
  damping.judge(1e-4, 5e-5, 1., 1e-3);
  BOOST_TEST(damping.stiffness(1e-4, 50.) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
