#include <deltaform/geometry/curvature.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  std::unique_ptr<Shape> make(const std::string &name, const std::string &entries)
  {
    ParameterTree tree = ParameterTree::parse(entries, "test.prm");
    Section section = tree.root();
    auto shape = Registry<Shape>::make(name, section);
    tree.check_unused();
    return shape;
  }

  void check_pole(const Shape &shape)
  {
    const double radius = smallest_radius(shape);
    const double round_off = 1e-15 * (std::isinf(radius) ? 1. : 1. + radius);
    for (const double z : {.3, -.1})
    {
      const Projection p = shape.project({0, z});
      BOOST_TEST(std::abs(p.distance - z) < round_off);
      BOOST_TEST(p.normal[0] == 0.);
      BOOST_TEST(p.normal[1] == 1.);
      BOOST_TEST(p.tangent[0] == 1.);
      BOOST_TEST(p.arc_length == 0.);
      for (const double r : {-1e-12, 1e-12})
      {
        const Projection q = shape.project({r, z});
        BOOST_TEST(std::abs(q.distance - z) < round_off);
        BOOST_TEST(std::abs(q.normal[0] - p.curvature * r) < 1e-20);
        BOOST_TEST(q.normal[1] == 1.);
        BOOST_TEST(std::abs(q.arc_length - p.slip_rate * r) < 1e-20);
      }
    }
  }

  constexpr double pi = 3.14159265358979323846;
} // namespace

BOOST_AUTO_TEST_SUITE(named_shapes)

BOOST_AUTO_TEST_CASE(hemispherical_punch)
{
  const auto shape = make("hemispherical punch", "set Radius = 50.8");
  check_pole(*shape);
  BOOST_TEST(smallest_radius(*shape) == 50.8);
  const Projection p = shape->project({60. * .6, 60. * .8 - 50.8});
  BOOST_TEST(std::abs(p.distance - 9.2) < 1e-13);
  BOOST_TEST(std::abs(p.curvature - 1 / 60.) < 1e-15);
  BOOST_TEST(std::abs(p.slip_rate - 50.8 / 60.) < 1e-14);
  // Far down the wall.
  const Projection wall = shape->project({51., -1e5});
  BOOST_TEST(std::abs(wall.distance - .2) < 1e-13);
  BOOST_TEST(wall.normal[0] == 1.);
  BOOST_TEST(std::abs(wall.arc_length - (50.8 * pi / 2 + 1e5 - 50.8)) < 1e-9);
  // The other side is a mirror image.
  const Projection left = shape->project({-60. * .6, 60. * .8 - 50.8});
  BOOST_TEST(left.distance == p.distance);
  BOOST_TEST(left.normal[0] == -p.normal[0]);
  BOOST_TEST(left.tangent[1] == -p.tangent[1]);
  BOOST_TEST(left.arc_length == -p.arc_length);
}

BOOST_AUTO_TEST_CASE(flat_punch)
{
  const auto shape = make("flat punch", "set Radius = 25\n set Edge radius = 5");
  check_pole(*shape);
  BOOST_TEST(shape->project({20, 2}).distance == 2.);
  const Projection edge = shape->project({20 + 3.6, -5 + 4.8});
  BOOST_TEST(std::abs(edge.distance - 1.) < 1e-14);
  BOOST_TEST(std::abs(edge.normal[0] - .6) < 1e-15);
  BOOST_TEST(shape->project({26, -300}).distance == 1.);
  BOOST_TEST(shape->project({26, -300}).normal[0] == 1.);

  const auto all_round = make("flat punch", "set Radius = 5\n set Edge radius = 5");
  check_pole(*all_round);
  const auto sharp = make("flat punch", "set Radius = 5\n set Edge radius = 0");
  BOOST_TEST(std::abs(sharp->project({5.3, .4}).distance - .5) < 1e-15);
  BOOST_CHECK_THROW(make("flat punch", "set Radius = 5\n set Edge radius = 5.1"), SceneError);
}

BOOST_AUTO_TEST_CASE(die)
{
  const auto shape = make("die", "set Throat radius = 1.0625\n set Profile radius = .25");
  BOOST_TEST(shape->project({2., .02}).distance == .02);
  BOOST_TEST(shape->project({1e9, .02}).distance == .02);
  BOOST_TEST(shape->project({1.3125, .02}).normal[1] == 1.);
  const Projection wall = shape->project({1., -7.});
  BOOST_TEST(wall.distance == .0625);
  BOOST_TEST(wall.normal[0] == -1.);
  BOOST_TEST(wall.tangent[1] == 1.);
  const Projection arc = shape->project({1.3125 - .3 * .6, -.25 + .3 * .8});
  BOOST_TEST(std::abs(arc.distance - .05) < 1e-15);
  BOOST_TEST(std::abs(arc.curvature - 1 / .3) < 1e-13);
  // Nothing is mirrored at the axis.
  BOOST_TEST(std::abs(shape->project({-.1, -7.}).distance - 1.1625) < 1e-15);

  const auto ring = make("die", "set Throat radius = 1\n set Profile radius = 0\n set Outer radius = 3");
  BOOST_TEST(std::abs(ring->project({.7, .4}).distance - .5) < 1e-15);
  BOOST_TEST(ring->project({3.5, -100.}).distance == .5);
  BOOST_CHECK_THROW(make("die", "set Throat radius = 1\n set Profile radius = 1\n set Outer radius = 2"), SceneError);
}

BOOST_AUTO_TEST_CASE(plate)
{
  const auto whole = make("plate", "");
  check_pole(*whole);
  for (const double r : {-1e6, -1., 0., 1e-12, 1e6})
    BOOST_TEST(whole->project({r, .25}).distance == .25);

  const auto ring = make("plate", "set Inner radius = 1.0625");
  BOOST_TEST(ring->project({1e6, .25}).distance == .25);
  BOOST_TEST(ring->project({1.0625, .25}).distance == .25);
  BOOST_TEST(std::abs(ring->project({1.0625 - .3, .4}).distance - .5) < 1e-15);
  BOOST_TEST(ring->project({1., -1.}).distance == .0625);

  const auto strip = make("plate", "set Inner radius = -2\n set Outer radius = 3\n set Edge radius = 1");
  BOOST_TEST(strip->project({-1., .5}).distance == .5);
  BOOST_TEST(std::abs(strip->project({-1 - 1.2, -1 + 1.6}).distance - 1.) < 1e-15);
  BOOST_TEST(strip->project({3.5, -9.}).distance == .5);
  BOOST_TEST(strip->project({-2.5, -9.}).distance == .5);
  BOOST_CHECK_NO_THROW(make("plate", "set Inner radius = -1\n set Outer radius = 1\n set Edge radius = 1"));
  BOOST_CHECK_THROW(make("plate", "set Inner radius = -1\n set Outer radius = 1\n set Edge radius = 1.01"), SceneError);
  BOOST_CHECK_THROW(make("plate", "set Inner radius = 1\n set Outer radius = 1"), SceneError);
}

BOOST_AUTO_TEST_CASE(circle)
{
  const auto cylinder = make("circle", "set Radius = 2");
  Projection p = cylinder->project({-1.8, 2.4});
  BOOST_TEST(std::abs(p.distance - 1.) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] + .6) < 1e-15);
  BOOST_TEST(std::abs(p.curvature - 1 / 3.) < 1e-15);
  BOOST_TEST(std::abs(p.slip_rate - 2 / 3.) < 1e-15);
  BOOST_TEST(std::abs(p.arc_length - 2 * (pi - std::atan2(.6, .8))) < 1e-14);
  BOOST_TEST(std::abs(cylinder->length() - 4 * pi) < 1e-14);
  BOOST_TEST(std::isfinite(cylinder->project({0, 0}).curvature));
  BOOST_TEST(cylinder->project({0, 0}).distance == -2.);
  // Across the seam at the bottom.
  const double a = cylinder->project({.01, -2.}).arc_length, b = cylinder->project({-.01, -2.}).arc_length;
  BOOST_TEST(std::abs(cylinder->slip(a, b) - 4 * std::atan(.005)) < 1e-13);

  const auto bore = make("circle", "set Radius = 2\n set Concave = true");
  p = bore->project({-.6, -.8});
  BOOST_TEST(std::abs(p.distance - 1.) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-15);
  BOOST_TEST(std::abs(p.curvature + 1.) < 1e-15);
  BOOST_TEST(std::abs(p.slip_rate - 2.) < 1e-15);
}

BOOST_AUTO_TEST_CASE(profile)
{
  const auto shape = make("profile", "set Points = 0 1; 4 1; 4 -5\n set Fillet radii = 0, 1, 0");
  BOOST_TEST(shape->in_scene_frame());
  BOOST_TEST(shape->project({-2., 1.5}).distance == .5);
  BOOST_TEST(std::abs(shape->project({3 + 1.2, 1.6}).distance - 1.) < 1e-15);
  const auto cut = make("profile", "set Points = 0 1; 4 1; 4 -5\n set Across the axis = false");
  BOOST_TEST(std::isinf(cut->project({-1e-6, 1.5}).distance));
  // A profile that ends on the axis, the blank below.
  const auto upper = make("profile", "set Points = 4 5; 4 1; 0 1\n set Fillet radii = 0, 1, 0");
  Projection p = upper->project({0., .5});
  BOOST_TEST(p.distance == .5);
  BOOST_TEST(p.normal[1] == -1.);
  const double length = upper->length();
  BOOST_TEST(std::abs(upper->project({-.5, .5}).arc_length - (length + .5)) < 1e-14);

  const auto refuses = [](const std::string &entries, const std::string &part) {
    BOOST_CHECK_EXCEPTION(make("profile", entries),
                          SceneError,
                          [&](const SceneError &error) {
                            BOOST_TEST_MESSAGE(error.what());
                            return std::string(error.what()).find(part) != std::string::npos;
                          });
  };
  refuses("set Points = 0 1; 4 1; 4 -5\n set Fillet radii = 0, 7, 0", "corner 2");
  refuses("set Points = 0 1; 4 1; 4 -5\n set Fillet radii = 0, 1", "3 points, but 2");
  refuses("set Points = 0 1; 0 1", "coincide");
  refuses("set Points = 0 1", "two points");
}

BOOST_AUTO_TEST_SUITE_END()
