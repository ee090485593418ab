// How deep a face is between its contact points, and what counts as a sharp corner of the tool.
#include "fake_surface.h"

#include <deltaform/contact/deepest_place.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double stiffness = 100., depth = 1e-3;

  /// Three nodes on a plate that ends at r = 1: two on its face, one beside its wall.
  DeepestPlaces over_the_end_of_a_plate(const std::string &edge_radius)
  {
    FakeSurface surface(3);
    surface.X = {Point2(.8, -depth), Point2(.9, -depth), Point2(1.02, -.2)};
    InterfaceFixture fixture(surface, {"Penalty rule=constant", "Penalty factor=50"},
                             flat + Entries{"Outer radius=1", "Edge radius=" + edge_radius});
    const Vector q(fixture.n);
    fixture.contact.begin_stage(q, 0.);
    fixture.begin_increment(q, 1., stiffness);
    fixture.settle(q);
    fixture.contact.commit(q);
    BOOST_TEST(fixture.contact.n_touching() >= 2u);
    return deepest_places(fixture.contact, q);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(deepest_place)

BOOST_AUTO_TEST_CASE(an_edge_over_a_sharp_corner_counts_apart)
{
  const auto [anywhere, off_corners] = over_the_end_of_a_plate("0");
  // The chord z = -depth - (r - .9)/.12 (.2 - depth) is as far from the face as from the wall where r - 1 = z.
  const double slope = (.2 - depth) / .12, r = (1. - depth + .9 * slope) / (1. + slope);
  BOOST_TEST(anywhere.depth == 1. - r, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(anywhere.place[0] == r, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(off_corners.depth == depth, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(off_corners.place[0] < .9 + 1e-9);
}


BOOST_AUTO_TEST_CASE(an_edge_over_a_radius_counts)
{
  const auto [anywhere, off_corners] = over_the_end_of_a_plate(".02");
  BOOST_TEST(anywhere.depth > 10. * depth);
  BOOST_TEST(off_corners.depth == anywhere.depth);
  BOOST_TEST((off_corners.place - anywhere.place).norm() == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
