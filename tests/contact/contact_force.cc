// The force of a contact point alone: its derivative by the place, on a circle of radius R about the origin where all
// is known in closed form.
#include "../blanks/dense_target.h"

#include <deltaform/contact/contact_force.h>

#include <cmath>

using namespace deltaform;

namespace
{
  constexpr double R = 2., eps = 30., eps_t = 7., mu = .2;

  struct Pressed
  {
    ContactForce force;
    double lambda;
  };

  /// A convex tool, at a place inside it; slipping friction follows lambda, sticking friction the arc length.
  Pressed at(const Point2 &x, const bool sticking)
  {
    Projection closest{};
    const double r = x.norm();
    closest.distance = r - R;
    closest.normal = Tensor1(x) / r;
    closest.tangent = Tensor1({closest.normal[1], -closest.normal[0]});
    closest.curvature = 1. / r;
    closest.slip_rate = R / r;
    closest.arc_length = R * std::atan2(x[0], x[1]);
    NormalResponse normal;
    normal.touching = true;
    normal.force = -eps * closest.distance;
    normal.derivative = -eps;
    FrictionResponse friction;
    friction.sticking = sticking;
    friction.force = sticking ? eps_t * closest.arc_length : mu * normal.force;
    friction.slip_rate = sticking ? eps_t : 0.;
    friction.force_rate = sticking ? 0. : mu;
    const SlipTransfer slip{closest.slip_rate, -closest.curvature * closest.slip_rate, 0., closest.slip_rate};
    return {ContactForce(closest, slip, normal, friction), normal.force};
  }
} // namespace

BOOST_AUTO_TEST_SUITE(contact_force)

BOOST_AUTO_TEST_CASE(derivative_by_the_place)
{
  for (const bool sticking : {true, false})
  {
    const Point2 x(.7, 1.8);
    const Pressed here = at(x, sticking);
    const Tensor2 gradient = here.force.gradient(here.lambda);
    constexpr double h = 1e-5;
    for (unsigned int d = 0; d < 2; ++d)
    {
      Point2 plus = x, minus = x;
      plus[d] += h;
      minus[d] -= h;
      const Tensor1 difference = (at(plus, sticking).force.value() - at(minus, sticking).force.value()) / (2. * h);
      for (unsigned int a = 0; a < 2; ++a)
        BOOST_TEST(std::abs(difference[a] - gradient[a][d]) < 1e-8 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(friction_does_the_work_of_the_interface)
{
  // Power on the blank is that of -t on the closest point: the force is t s, the closest moves by s.
  const Point2 x(.7, 1.8);
  const double r = x.norm();
  const Tensor1 tangent({x[1] / r, -x[0] / r});
  const double t = mu * -eps * (r - R);
  BOOST_TEST(std::abs(at(x, false).force.value() * tangent + t * R / r) < 1e-13);
  // An unknown normal force brings its friction with it.
  const Tensor1 by_multiplier = at(x, false).force.by_multiplier();
  BOOST_TEST(std::abs(by_multiplier * at(x, false).force.normal() - 1.) < 1e-14);
  BOOST_TEST(std::abs(by_multiplier * tangent + mu * R / r) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
