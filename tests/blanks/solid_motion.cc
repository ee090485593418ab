// How points of a solid move and flow, by themselves: against closed forms.
#include "../../source/blanks/solid_motion.h"

#include <deltaform/io/keyed_arrays.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  constexpr double root_2 = 1.41421356237309504880;

  /// Stretches of r and z, then a turn; row-major.
  std::array<double, 4> stretched_and_turned(const double r, const double z, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * r, -s * z, s * r, c * z}};
  }

  void go_to(SolidMotion &motion, const double r, const double z, const double hoop, const double angle)
  {
    motion.now(0).f = stretched_and_turned(r, z, angle);
    motion.now(0).hoop = hoop;
  }

  void check_close(const Mandel &found, const Mandel &expected)
  {
    for (unsigned int k = 0; k < 4; ++k)
      BOOST_TEST(std::abs(found[k] - expected[k]) < 1e-14, "component " << k << ": " << found[k] << ", not "
                                                                        << expected[k]);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(solid_motion)

BOOST_AUTO_TEST_CASE(an_increment_starts_where_the_last_one_ended)
{
  SolidMotion motion(true);
  motion.reset(1, true);
  go_to(motion, 1.5, .8, 1.1, .4);
  motion.commit();
  go_to(motion, 1.5 * std::exp(.02), .8 * std::exp(-.03), 1.1 * std::exp(.01), .4);
  BOOST_TEST(motion.increment_size().strain == .03, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(motion.increment_size().rotation) < 1e-14);
  go_to(motion, 1.5, .8, 1.1, .4 + .25);
  BOOST_TEST(std::abs(motion.increment_size().strain) < 1e-14);
  BOOST_TEST(motion.increment_size().rotation == .25, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(tensors_turn_with_the_material)
{
  // R diag(3, 1, 2) R^T with the direction (cos, sin) of the first axis.
  SolidMotion motion(true);
  motion.reset(1, true);
  go_to(motion, 1., 1., 1., .3);
  const double c = std::cos(.3), s = std::sin(.3);
  check_close(motion.turn(0)({{3., 1., 2., 0.}}), {{3. * c * c + s * s, 3. * s * s + c * c, 2., root_2 * 2. * c * s}});
  // Of small strain the axes stay.
  SolidMotion small(false);
  small.reset(1, true);
  go_to(small, 1., 1., 1., .3);
  check_close(small.turn(0)({{3., 1., 2., .5}}), {{3., 1., 2., .5}});
}

BOOST_AUTO_TEST_CASE(strain_without_elastic_part_is_plastic)
{
  SolidMotion motion(true);
  motion.reset(1, false);
  const double r = .4, z = -.3, hoop = .2, mean = .1, angle = .7;
  go_to(motion, std::exp(r), std::exp(z), std::exp(hoop), 0.);
  check_close(motion.strain(motion.now(0)), {{r, z, hoop, 0.}});
  motion.flow_to(0, Mandel{});
  check_close(motion.plastic_strain(0, motion.now(0)), {{r - mean, z - mean, hoop - mean, 0.}});
  // An elastic deviator is what is missing.
  motion.flow_to(0, {{.02, -.01, -.01, 0.}});
  check_close(motion.plastic_strain(0, motion.now(0)), {{r - mean - .02, z - mean + .01, hoop - mean + .01, 0.}});
  // Turned with the material: the plastic metric belongs to the undeformed body and does not notice.
  go_to(motion, std::exp(r), std::exp(z), std::exp(hoop), angle);
  motion.flow_to(0, Mandel{});
  const double c = std::cos(angle), s = std::sin(angle), along = r - mean, across = z - mean;
  check_close(motion.plastic_strain(0, motion.now(0)),
              {{c * c * along + s * s * across,
                s * s * along + c * c * across,
                hoop - mean,
                root_2 * c * s * (along - across)}});
}

BOOST_AUTO_TEST_CASE(state_goes_over)
{
  SolidMotion motion(true), other(true);
  motion.reset(1, true);
  other.reset(1, true);
  go_to(motion, 1.2, .9, 1.05, .1);
  motion.flow_to(0, {{.01, -.01, 0., .002}});
  motion.remember_turn(0, motion.turn(0));
  motion.volume_offset(0) = .003;
  motion.commit();
  KeyedArrays state, again;
  SolidMotion::each_array(motion, PutInto(state));
  SolidMotion::each_array(other, TakeFrom(state));
  other.start_from_committed();
  BOOST_TEST(std::abs(other.increment_size().strain) < 1e-15);
  BOOST_TEST((other.plastic_metric(0) == motion.plastic_metric(0)));
  SolidMotion::each_array(other, PutInto(again));
  BOOST_TEST((again == state));
  BOOST_CHECK_THROW(SolidMotion::each_array(other, TakeFrom(KeyedArrays())), SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
