#include "../blanks/dense_target.h"

#include <deltaform/stage/released_forces.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  ReleasedForces forces(const bool at_once)
  {
    ReleasedForces result;
    result.reset(3, 1, 1, 1);
    result.any = true;
    result.on_blank[1] = 8.;
    Stage stage;
    stage.begin = 1.;
    stage.end = 3.;
    stage.release_at_once = at_once;
    result.begin_stage(stage);
    return result;
  }

  double residual(const ReleasedForces &released, const double time)
  {
    testing::DenseTarget target(3, false);
    released.add(time, target);
    BOOST_TEST(target.residual[0] == 0.);
    BOOST_TEST(target.residual[2] == 0.);
    return target.residual[1];
  }
} // namespace

BOOST_AUTO_TEST_SUITE(released_forces)

BOOST_AUTO_TEST_CASE(they_fade_linearly_over_the_stage)
{
  const ReleasedForces released = forces(false);
  BOOST_TEST(residual(released, 1.) == -8.);
  BOOST_TEST(residual(released, 1.5) == -6.);
  BOOST_TEST(residual(released, 3.) == 0.);
  BOOST_TEST(released.share(1.5) == .75);
}

BOOST_AUTO_TEST_CASE(or_are_gone_at_once)
{
  BOOST_TEST(residual(forces(true), 1.0001) == 0.);
}

BOOST_AUTO_TEST_CASE(nothing_released_has_no_share)
{
  ReleasedForces released = forces(false);
  released.reset(3, 1, 1, 1);
  BOOST_TEST(released.share(1.5) == 0.);
  BOOST_TEST(residual(released, 1.) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
