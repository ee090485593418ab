// Where contact wants the edges of a solid to be shorter.
#include "fake_surface.h"

#include <deltaform/contact/contact_measures.h>

#include <limits>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  /// A block's upper corner of radius .5: flat for x < -.5, a wall below z = -.5.
  const Entries corner = {"Shape=profile",
                          "Points=-5 0; 0 0; 0 -5",
                          "Fillet radii=0, .5, 0",
                          "Across the axis=false",
                          "Side=bottom",
                          "Position z=0"};

  /// Longest undeformed length that a share of a tenth allows to the edge between two points, displaced by u.
  double longest(const Point2 &A,
                 const Point2 &B,
                 const Entries &tool = corner,
                 const std::vector<double> &u = {0., 0., 0., 0.},
                 const bool clamped = false)
  {
    FakeSurface surface(2);
    surface.X = {A, B};
    InterfaceFixture fixture(surface, {"Enforcement=penalty"}, tool);
    Vector q(fixture.n);
    for (unsigned int i = 0; i < 4; ++i)
      q[i] = u[i];
    fixture.contact.begin_stage(q, 0.);
    fixture.begin_increment(q, 1., 1e3);
    fixture.converge(q);
    fixture.contact.commit(q);
    std::vector<double> result;
    EdgeWishes wishes{.1};
    wishes.clamped = {clamped};
    shorten_edges(fixture.contact, q, wishes, result);
    BOOST_TEST_REQUIRE(result.size() == 1u);
    return result.front();
  }

  const auto near = boost::test_tools::tolerance(1e-3); // the nodes penetrate
} // namespace

BOOST_AUTO_TEST_SUITE(contact_edges)

BOOST_AUTO_TEST_CASE(an_arc_at_the_ends)
{
  const double p = .5 - 1e-4, c = std::cos(.5), s = std::sin(.5);
  BOOST_TEST(longest(Point2(-.5 + p * s, -.5 + p * c), Point2(-.5 + p * c, -.5 + p * s)) == .05, near);
  BOOST_TEST(longest(Point2(-3., -1e-4), Point2(-1., -1e-4)) == infinity); // flat
}

BOOST_AUTO_TEST_CASE(an_arc_between_the_ends)
{
  // Both ends on the straights beside the fillet, which is .5 (sqrt(2) - 1) deep in the edge or more.
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(-1e-4, -.8)) == .05, near);
  BOOST_TEST(longest(Point2(-3., -1e-4), Point2(-1e-4, -4.)) == .05, near);
  // One end touches, and the other is over the fillet, near or far.
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(1.2, .2)) == .05, near);
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(.2, 1.7)) == infinity);
  // Nothing touches and nothing is near.
  BOOST_TEST(longest(Point2(-.8, 2.), Point2(2., -.8)) == infinity);
}

BOOST_AUTO_TEST_CASE(a_sharp_corner_between_the_ends)
{
  Entries sharp = corner;
  sharp[2] = "Fillet radii=0, 0, 0";
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(-1e-4, -.8), sharp) == 0.);
  // A corner that points away from the blank asks for nothing.
  const Entries dent = {
    "Shape=profile", "Points=-5 0; 0 0; 0 5", "Across the axis=false", "Side=bottom", "Position z=0"};
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(1e-4, .8), dent) == infinity);
}

BOOST_AUTO_TEST_CASE(a_stretched_edge_counts_as_it_is_now)
{
  // From a quarter of its present length: only a quarter of the undeformed length is allowed.
  const Point2 A(-.8, -1e-4), B(-1e-4, -.8);
  const Tensor1 shift = .75 * (A - B);
  BOOST_TEST(longest(A, Point2(B + shift), corner, {0., 0., -shift[0], -shift[1]}) == .0125, near);
}

BOOST_AUTO_TEST_CASE(a_clamped_edge_is_allowed_less)
{
  BOOST_TEST(longest(Point2(-.8, -1e-4), Point2(-1e-4, -.8), corner, {0., 0., 0., 0.}, true) == .03, near);
  BOOST_TEST(longest(Point2(-3., -1e-4), Point2(-1., -1e-4), corner, {0., 0., 0., 0.}, true) == infinity);
}

BOOST_AUTO_TEST_CASE(what_a_tool_touches_is_clamped_and_what_is_next_to_it)
{
  FakeSurface surface(6);
  surface.X = {{-5., 1.}, {-4., 1.}, {-3., -1e-4}, {-2., 1.}, {-1., 1.}, {0., 1.}};
  InterfaceFixture fixture(surface, {"Enforcement=penalty"}, corner);
  const Vector q(fixture.n);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., 1e3);
  fixture.converge(q);
  fixture.contact.commit(q);
  std::vector<bool> clamped;
  clamp_edges(fixture.contact, clamped);
  BOOST_TEST((clamped == std::vector<bool>{true, true, true, true, false}));
}

BOOST_AUTO_TEST_SUITE_END()
