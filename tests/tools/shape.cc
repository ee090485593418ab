#include <deltaform/geometry/curvature.h>
#include <deltaform/tools/shape.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace deltaform;

namespace
{
  struct Polygon : Shape
  {
    Polygon(const std::vector<Point2> &points, const std::vector<double> &radii, const bool closed = false)
    {
      if (closed)
        build_closed(points, radii);
      else
        build(points, radii);
    }
    Polygon(const std::vector<Point2> &points, const std::vector<double> &radii, const End start, const End end)
    {
      build(points, radii, start, end);
    }
  };

  void check_message(const std::vector<Point2> &points,
                     const std::vector<double> &radii,
                     const std::string &part,
                     const bool closed = false)
  {
    BOOST_CHECK_EXCEPTION(Polygon(points, radii, closed),
                          std::invalid_argument,
                          [&](const std::invalid_argument &error) {
                            BOOST_TEST_MESSAGE(error.what());
                            return std::string(error.what()).find(part) != std::string::npos;
                          });
  }

  constexpr double pi = 3.14159265358979323846;
} // namespace

BOOST_AUTO_TEST_SUITE(shape)

BOOST_AUTO_TEST_CASE(fillets_become_arcs)
{
  // A step down with a convex fillet of 1, then up with a concave one of 2.
  const Polygon profile({{0, 0}, {4, 0}, {4, -6}, {10, -6}}, {0, 1, 2, 0});
  const auto &s = profile.segments();
  BOOST_TEST_REQUIRE(s.size() == 5u);
  BOOST_TEST(s[0].length == 3.);
  BOOST_TEST(s[1].convex);
  BOOST_TEST(s[1].center.distance(Point2(3, -1)) < 1e-15);
  BOOST_TEST(s[1].sweep == -pi / 2);
  BOOST_TEST(s[2].length == 3.);
  BOOST_TEST(!s[3].convex);
  BOOST_TEST(s[3].center.distance(Point2(6, -4)) < 1e-15);
  BOOST_TEST(s[3].sweep == pi / 2);
  BOOST_TEST(s[4].length == 4.);
  BOOST_TEST(std::abs(profile.length() - (10 + 1.5 * pi)) < 1e-14);
  BOOST_TEST(smallest_radius(profile) == 1.);
  BOOST_TEST(profile.bounding_box().first.distance(Point2(0, -6)) < 1e-15);
  BOOST_TEST(profile.bounding_box().second.distance(Point2(10, 0)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(hand_computed_projections)
{
  const Polygon profile({{0, 0}, {4, 0}, {4, -6}, {10, -6}}, {0, 1, 2, 0});
  // On the first line, inside the tool.
  Projection p = profile.project({2, -.25});
  BOOST_TEST(p.distance == -.25);
  BOOST_TEST(p.normal[0] == 0.);
  BOOST_TEST(p.normal[1] == 1.);
  BOOST_TEST(p.curvature == 0.);
  BOOST_TEST(p.slip_rate == 1.);
  BOOST_TEST(p.arc_length == 2.);
  // Off the convex fillet, along (3, 4)/5 from its center: radius 1, distance 1.5.
  p = profile.project({3 + 2.5 * .6, -1 + 2.5 * .8});
  BOOST_TEST(std::abs(p.distance - 1.5) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-15);
  BOOST_TEST(std::abs(p.tangent[1] + .6) < 1e-15);
  BOOST_TEST(std::abs(p.curvature - 1 / 2.5) < 1e-15);
  BOOST_TEST(std::abs(p.slip_rate - 1 / 2.5) < 1e-15);
  BOOST_TEST(std::abs(p.arc_length - (3 + std::atan2(.6, .8))) < 1e-15);
  // In the concave fillet of radius 2, half way from its center (6, -4) down to the left.
  p = profile.project({6 - .6, -4 - .8});
  BOOST_TEST(std::abs(p.distance - 1.) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-14);
  BOOST_TEST(std::abs(p.curvature + 1.) < 1e-14);
  BOOST_TEST(std::abs(p.slip_rate - 2.) < 1e-14);
  BOOST_TEST(std::abs(p.arc_length - (3 + pi / 2 + 3 + 2 * std::atan2(.8, .6))) < 1e-14);
  // At that center, where everything is equally close: finite, and the normal leaves the tool.
  p = profile.project({6, -4});
  BOOST_TEST(p.distance == 2.);
  BOOST_TEST(std::isfinite(p.curvature));
  BOOST_TEST(std::abs(p.normal.norm() - 1) < 1e-15);
  BOOST_TEST(p.normal[0] >= 0.);
  BOOST_TEST(p.normal[1] >= 0.);
}

BOOST_AUTO_TEST_CASE(sharp_corners)
{
  const Polygon profile({{0, 0}, {4, 0}, {4, -6}, {10, -6}}, {0, 0, 0, 0});
  Projection p = profile.project({4.3, .4});
  BOOST_TEST(std::abs(p.distance - .5) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-15);
  BOOST_TEST(std::abs(p.curvature - 2.) < 1e-14); // 1/d
  BOOST_TEST(p.slip_rate == 0.);
  BOOST_TEST(p.arc_length == 4.);
  // At the corner itself nothing is infinite.
  p = profile.project({4, 0});
  BOOST_TEST(p.distance == 0.);
  BOOST_TEST(std::isfinite(p.curvature));
  BOOST_TEST(std::abs(p.normal.norm() - 1) < 1e-15);
  // The corner that turns the other way is closest only from inside the tool.
  p = profile.project({4 - .3, -6 - .4});
  BOOST_TEST(std::abs(p.distance + .5) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-14);
  BOOST_TEST(std::abs(p.normal[1] - .8) < 1e-14);
  BOOST_TEST(std::abs(p.curvature + 2.) < 1e-13); // still 1/d
  BOOST_TEST(p.slip_rate == 0.);
  p = profile.project({4.1, -5.8});
  BOOST_TEST(std::abs(p.distance - .1) < 1e-15);
  BOOST_TEST(p.normal[0] == 1.);
}

BOOST_AUTO_TEST_CASE(free_and_endless_ends)
{
  const std::vector<Point2> points{{0, 0}, {4, 0}};
  const Polygon free(points, {0, 0});
  BOOST_TEST(free.project({0, 1}).distance == 1.);
  BOOST_TEST(free.project({4, -1}).distance == -1.);
  BOOST_TEST(free.project({4, 0}).distance == 0.);
  for (const Point2 &x : {Point2(-1e-6, 1), Point2(4.001, 1), Point2(-1e-6, 0), Point2(7, -3)})
    BOOST_TEST(std::isinf(free.project(x).distance));

  const Polygon endless(points, {0, 0}, Shape::End::endless, Shape::End::endless);
  BOOST_TEST(endless.project({-1e6, 1}).distance == 1.);
  BOOST_TEST(endless.project({-1e6, 1}).arc_length == -1e6);
  BOOST_TEST(endless.project({1e6, 2}).distance == 2.);
  BOOST_TEST(std::isinf(endless.bounding_box().second[0]));
  BOOST_TEST(endless.bounding_box().second[1] == 0.);
  const auto drawn = endless.polyline(.02, 10.);
  BOOST_TEST_REQUIRE(drawn.size() == 2u);
  BOOST_TEST(drawn[0][0] == -6.);
  BOOST_TEST(drawn[1][0] == 10.);
}

BOOST_AUTO_TEST_CASE(a_cone_on_the_axis)
{
  const double a = std::sqrt(.5);
  const Polygon cone({{0, 0}, {3, -3}}, {0, 0}, Shape::End::axis, Shape::End::endless);
  for (const double r : {0., -1e-12, 1e-12})
  {
    const Projection p = cone.project({r, .5});
    BOOST_TEST(p.distance == .5);
    BOOST_TEST(std::abs(p.normal[0] - 2 * r) < 1e-20);
    BOOST_TEST(p.normal[1] == 1.);
    BOOST_TEST(std::abs(p.curvature - 2.) < 1e-15);
  }
  const Projection right = cone.project({1, 1}), left = cone.project({-1, 1});
  BOOST_TEST(std::abs(right.distance - std::sqrt(2.)) < 1e-15);
  BOOST_TEST(std::abs(left.distance - std::sqrt(2.)) < 1e-15);
  BOOST_TEST(std::abs(left.normal[0] + a) < 1e-15);
  BOOST_TEST(std::abs(left.tangent[0] - a) < 1e-15);
  BOOST_TEST(std::abs(left.tangent[1] - a) < 1e-15);
  BOOST_TEST(cone.project({-2, -1}).arc_length == -cone.project({2, -1}).arc_length);

  const auto drawn = cone.polyline(.02, 0., true);
  BOOST_TEST_REQUIRE(drawn.size() == 3u);
  BOOST_TEST(drawn[0].distance(Point2(-3, -3)) < 1e-14);
  BOOST_TEST(drawn[1].distance(Point2(0, 0)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_closed_profile_has_no_end)
{
  const Polygon square({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, {0, 0, 0, 0}, true);
  BOOST_TEST(square.segments().size() == 8u);
  BOOST_TEST(std::abs(square.length() - 8.) < 1e-15);
  BOOST_TEST(std::abs(square.project({-1.3, -1.4}).distance - .5) < 1e-15);
  BOOST_TEST(square.project({.2, -1.5}).distance == .5);
  BOOST_TEST(square.project({.9, .1}).distance < 0.);
  BOOST_TEST(std::abs(square.slip(7.9, .2) - .3) < 1e-14);
  BOOST_TEST(std::abs(square.slip(.2, 7.9) + .3) < 1e-14);
  BOOST_TEST(square.polyline().front().distance(square.polyline().back()) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_smallest_radius_between_two_feet)
{
  const double infinity = std::numeric_limits<double>::infinity();
  // Convex of radius 1 at s in [3, 3 + pi/2], concave of radius 2 from 6 + pi/2 to 6 + 3 pi/2.
  const Polygon profile({{0, 0}, {4, 0}, {4, -6}, {10, -6}}, {0, 1, 2, 0});
  BOOST_TEST(smallest_radius(profile, 0., 2.9) == infinity);
  BOOST_TEST(smallest_radius(profile, 2.9, 5.) == 1.);
  BOOST_TEST(smallest_radius(profile, 5., 2.9) == 1.);
  BOOST_TEST(smallest_radius(profile, 5., 8.) == 2.);
  BOOST_TEST(smallest_radius(profile, 1., 12.) == 1.);
  BOOST_TEST(smallest_radius(profile, 4.6, 7.5) == infinity); // the straight between them
  // A sharp corner that points to the blank, and one that does not.
  const Polygon sharp({{0, 0}, {4, 0}, {4, -6}, {10, -6}}, {0, 0, 0, 0});
  BOOST_TEST(smallest_radius(sharp, 3., 5.) == 0.);
  BOOST_TEST(smallest_radius(sharp, 9., 11.) == infinity);
  // Across the axis, and the short way round a closed profile.
  const Polygon punch({{0, 0}, {4, 0}, {4, -6}}, {0, 1, 0}, Shape::End::axis, Shape::End::free);
  BOOST_TEST(smallest_radius(punch, -2., 2.) == infinity);
  BOOST_TEST(smallest_radius(punch, -4., 2.) == 1.);
  const Polygon square({{0, 0}, {0, 2}, {2, 2}, {2, 0}}, {0., .2, .3, 0.}, true);
  BOOST_TEST(smallest_radius(square, .5, 1.) == infinity);
  BOOST_TEST(smallest_radius(square, 1., 2.5) == .2);
  BOOST_TEST(smallest_radius(square, .5, square.length() - .5) == 0.); // over the corner where it begins
}

BOOST_AUTO_TEST_CASE(impossible_profiles_name_the_corner)
{
  const std::vector<Point2> step{{0, 0}, {4, 0}, {4, -6}, {10, -6}};
  check_message(step, {0, 4.1, 0, 0}, "fillet radius 4.1 at corner 2 (4 0)");
  check_message(step, {0, 3, 3.5, 0}, "fillet radius 3.5 at corner 3 (4 -6)");
  check_message(step, {0, -1, 0, 0}, "corner 2");
  check_message(step, {0, 0, 0}, "4 points, but 3");
  check_message({{0, 0}, {1, 0}, {1, 0}, {2, 0}}, {0, 0, 0, 0}, "points 2 and 3 coincide");
  check_message({{0, 0}, {1, 0}, {0, 0}}, {0, 0, 0}, "back on itself at corner 2");
  check_message({{0, 0}}, {0}, "two points");
  check_message({{0, 0}, {std::nan(""), 0}, {2, 0}}, {0, 0, 0}, "not a number");
  check_message({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {.6, .6, .1, .1}, "corner 1 ", true);
  check_message({{0, 0}, {1, 1}, {0, 0}}, {0, 0, 0}, "points 3 and 1 coincide", true);
  // What fits exactly fits.
  BOOST_CHECK_NO_THROW(Polygon(step, {0, 4, 2, 0}));
  BOOST_CHECK_NO_THROW(Polygon({{.1, .1}, {.1, .4}, {.4, .4}, {.4, .1}}, {.15, .15, .15, .15}, true));
  // A fillet where the profile goes straight on is no arc.
  BOOST_TEST(Polygon({{0, 0}, {1, 0}, {2, 0}}, {0, 5, 0}).segments().size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
