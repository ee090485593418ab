// How deep a face is between its contact points, and what counts as a sharp corner of the tool.
#include "fake_surface.h"

#include <deltaform/contact/deepest_place.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double stiffness = 100., depth = 1e-3;

  /// The same edges with contact points inside them, as solids have.
  class PointsInside : public FakeSurface
  {
  public:
    using FakeSurface::FakeSurface;

    unsigned int n_contact_points(Side) const override
    {
      return places.size() * edges.size();
    }

    void contact_point(const Vector &q,
                       const Side side,
                       const unsigned int i,
                       const ContactThickness thickness,
                       ContactPoint &point) const override
    {
      contact_place(q, side, i / places.size(), places[i % places.size()][0], thickness, point);
      point.area = area / places.size();
    }

    void contact_place(const Vector &q,
                       Side,
                       const unsigned int edge,
                       const double xi,
                       ContactThickness,
                       ContactPoint &point) const override
    {
      point = ContactPoint();
      point.n_nodes = 2;
      point.n_dofs = 4;
      for (unsigned int a = 0; a < 2; ++a)
      {
        const unsigned int node = edges[edge][a];
        const double share = a == 0 ? 1. - xi : xi;
        point.nodes[a] = {node, share};
        for (unsigned int d = 0; d < 2; ++d)
        {
          point.dofs[2 * a + d] = 2 * node + d;
          point.x[d] += share * (X[node][d] + q[2 * node + d]);
          point.jacobian[2 * a + d][d] = share;
        }
      }
    }

    unsigned int points_per_edge() const override
    {
      return places.size();
    }

    std::vector<dealii::Point<1>> points_of_edge(Side, unsigned int) const override
    {
      return places;
    }

    std::vector<dealii::Point<1>> places{dealii::Point<1>(.2), dealii::Point<1>(.8)};
  };

  /// Three nodes on a plate that ends at r = 1: two on its face, one beside its wall.
  template <typename Surface>
  DeepestPlaces over_the_end_of_a_plate(const std::string &edge_radius)
  {
    Surface surface(3);
    surface.X = {Point2(.8, -depth), Point2(.9, -depth), Point2(1.02, -.2)};
    InterfaceFixture fixture(surface, {"Penalty rule=constant", "Penalty factor=50"},
                             flat + Entries{"Outer radius=1", "Edge radius=" + edge_radius});
    const Vector q(fixture.n);
    fixture.contact.begin_stage(q, 0.);
    fixture.begin_increment(q, 1., stiffness);
    fixture.converge(q);
    fixture.contact.commit(q);
    BOOST_TEST(fixture.contact.n_touching() >= 2u);
    return deepest_places(fixture.contact, q);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(deepest_place)

using Surfaces = boost::mpl::list<FakeSurface, PointsInside>;

BOOST_AUTO_TEST_CASE_TEMPLATE(an_edge_over_a_sharp_corner_counts_apart, Surface, Surfaces)
{
  const auto [anywhere, off_corners] = over_the_end_of_a_plate<Surface>("0");
  // The chord z = -depth - (r - .9)/.12 (.2 - depth) is as far from the face as from the wall where r - 1 = z.
  const double slope = (.2 - depth) / .12, r = (1. - depth + .9 * slope) / (1. + slope);
  BOOST_TEST(anywhere.depth == 1. - r, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(anywhere.place[0] == r, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(off_corners.depth == depth, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(off_corners.place[0] < .9 + 1e-9);
}


BOOST_AUTO_TEST_CASE_TEMPLATE(an_edge_over_a_radius_counts, Surface, Surfaces)
{
  const auto [anywhere, off_corners] = over_the_end_of_a_plate<Surface>(".02");
  BOOST_TEST(anywhere.depth > 10. * depth);
  BOOST_TEST(off_corners.depth == anywhere.depth);
  BOOST_TEST((off_corners.place - anywhere.place).norm() == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
