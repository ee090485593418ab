#include "../messages.h"

#include <deltaform/geometry/meridian.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace deltaform;

namespace
{
  constexpr double PI = 3.14159265358979323846;

  Tensor1 direction(const double angle)
  {
    return Tensor1({std::cos(angle), std::sin(angle)});
  }

  /// The pieces follow each other without a gap, and without a kink where there is a fillet.
  void check_chain(const std::vector<MeridianPiece> &pieces, const bool smooth)
  {
    double arc = 0.;
    for (unsigned int i = 0; i < pieces.size(); ++i)
    {
      const MeridianPiece &piece = pieces[i];
      BOOST_TEST(std::abs(piece.arc_start - arc) < 1e-13);
      BOOST_TEST(piece.length > 0.);
      arc += piece.length;
      if (i + 1 < pieces.size())
      {
        BOOST_TEST(piece.point_at(piece.length).distance(pieces[i + 1].start) < 1e-13);
        if (smooth)
          BOOST_TEST((direction(piece.angle_at(piece.length)) - direction(pieces[i + 1].angle)).norm() < 1e-13);
      }
      // The tangent is the derivative of the position, of length one.
      constexpr double h = 1e-5;
      for (const double s : {.2 * piece.length, .7 * piece.length})
        BOOST_TEST(((piece.point_at(s + h) - piece.point_at(s - h)) / (2. * h) - direction(piece.angle_at(s))).norm() <
                   1e-8);
    }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(meridian)

BOOST_AUTO_TEST_CASE(straight_lines)
{
  const auto pieces = build_meridian({{0., 0.}, {3., 0.}, {3., 4.}}, {0., 0., 0.});
  BOOST_TEST_REQUIRE(pieces.size() == 2u);
  check_chain(pieces, false);
  BOOST_TEST(pieces[0].length == 3.);
  BOOST_TEST(pieces[1].length == 4.);
  BOOST_TEST(std::abs(pieces[1].angle - PI / 2.) < 1e-15);
  BOOST_TEST(pieces[1].curvature == 0.);
}

BOOST_AUTO_TEST_CASE(a_cup)
{
  // Bottom, fillet to the left, wall: the center of the fillet is at (2, 1).
  const auto pieces = build_meridian({{0., 0.}, {3., 0.}, {3., 4.}}, {0., 1., 0.});
  BOOST_TEST_REQUIRE(pieces.size() == 3u);
  check_chain(pieces, true);
  BOOST_TEST(std::abs(pieces[1].curvature - 1.) < 1e-15);
  BOOST_TEST(std::abs(pieces[1].length - PI / 2.) < 1e-14);
  for (const double s : {0., .3, 1.2})
    BOOST_TEST(std::abs(pieces[1].point_at(s).distance(Point2(2., 1.)) - 1.) < 1e-14);
  BOOST_TEST(std::abs(pieces[2].length - 3.) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_quarter_circle_has_no_lines)
{
  const auto pieces = build_meridian({{1., 0.}, {1., 1.}, {0., 1.}}, {0., 1., 0.});
  BOOST_TEST_REQUIRE(pieces.size() == 1u);
  BOOST_TEST(pieces[0].point_at(pieces[0].length).distance(Point2(0., 1.)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(random_polylines)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (unsigned int sample = 0; sample < 100; ++sample)
  {
    // Sizes such that the fillets fit: edges of at least 1, turns below 100 degrees.
    std::vector<Point2> points{{0., 0.}};
    std::vector<double> radii{0.};
    double angle = uniform(generator);
    for (unsigned int i = 0; i < 4; ++i)
    {
      points.push_back(points.back() + (2. + uniform(generator)) * direction(angle));
      radii.push_back(.2 + .15 * uniform(generator));
      angle += 1.7 * uniform(generator);
    }
    radii.back() = 0.;
    const auto pieces = build_meridian(points, radii);
    check_chain(pieces, true);
    BOOST_TEST(pieces.front().start.distance(points.front()) < 1e-14);
    BOOST_TEST(pieces.back().point_at(pieces.back().length).distance(points.back()) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(wrong_polylines)
{
  const auto message = [](const std::vector<Point2> &points, const std::vector<double> &radii) {
    return message_of<std::invalid_argument>([&] { build_meridian(points, radii); });
  };
  check_contains(message({{0., 0.}}, {0.}), {"two points"});
  check_contains(message({{0., 0.}, {1., 0.}}, {0.}), {"There are 2 points, but 1 fillet radii"});
  check_contains(message({{0., 0.}, {1., 0.}, {1., 0.}}, {0., 0., 0.}), {"points 2 and 3 coincide at (1 0)"});
  check_contains(message({{0., 0.}, {1., 0.}, {1., 1.}}, {0., 1.1, 0.}),
                 {"fillet radius 1.1 at corner 2 (1 0) does not fit"});
}

BOOST_AUTO_TEST_SUITE_END()
