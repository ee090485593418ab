// A blank that is refined: what its new contact points inside the edges take over.
#include "fake_surface.h"

#include <deltaform/parameters/registry.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double stiffness = 1e3;
  const std::array<double, 4> places{{.1, .4, .6, .9}}, weights{{.2, .3, .3, .2}};

  /// Straight edges from 0 to 4 with four points inside each.
  class Line : public FakeSurface
  {
  public:
    explicit Line(const unsigned int n_edges)
      : FakeSurface(n_edges + 1)
    {
      place_nodes();
    }

    /// Every edge becomes two.
    void halve()
    {
      const unsigned int n_edges = 2 * edges.size();
      X.resize(n_edges + 1);
      edges.clear();
      for (unsigned int e = 0; e < n_edges; ++e)
        edges.push_back({{e, e + 1, invalid_index}});
      place_nodes();
    }

    unsigned int n_contact_points(Side) const override
    {
      return 4 * edges.size();
    }

    unsigned int points_per_edge() const override
    {
      return 4;
    }

    double point_weight(Side, const unsigned int i) const override
    {
      return weights[i % 4];
    }

    void contact_point(const Vector &q,
                       const Side side,
                       const unsigned int i,
                       const ContactThickness thickness,
                       ContactPoint &point) const override
    {
      contact_place(q, side, i / 4, places[i % 4], thickness, point);
      point.area = weights[i % 4] * 4. / edges.size();
    }

    void contact_place(const Vector &q,
                       Side,
                       const unsigned int e,
                       const double xi,
                       ContactThickness,
                       ContactPoint &point) const override
    {
      point = ContactPoint();
      point.n_nodes = 2;
      point.n_dofs = 4;
      for (const unsigned int a : {0, 1})
      {
        const double share = a == 0 ? 1. - xi : xi;
        point.nodes[a] = {e + a, share};
        for (const unsigned int d : {0, 1})
        {
          const unsigned int k = 2 * a + d;
          point.dofs[k] = 2 * (e + a) + d;
          point.jacobian[k][d] = share;
          point.x[d] += share * (X[e + a][d] + q[point.dofs[k]]);
        }
      }
    }

    /// Of every point after halve().
    static std::vector<PointOrigin> origins(const unsigned int n_old_edges)
    {
      std::vector<double> old;
      for (unsigned int i = 0; i < 4 * n_old_edges; ++i)
        old.push_back(i / 4 + places[i % 4]);
      std::vector<PointOrigin> result;
      for (unsigned int i = 0; i < 8 * n_old_edges; ++i)
      {
        const double place = .5 * (i / 4 + places[i % 4]);
        const unsigned int b = std::lower_bound(old.begin(), old.end(), place) - old.begin();
        if (b == 0 || b == old.size())
          result.push_back({b == 0 ? 0 : b - 1, b == 0 ? 0 : b - 1, 0.});
        else
          result.push_back({b - 1, b, (place - old[b - 1]) / (old[b] - old[b - 1])});
      }
      return result;
    }

  private:
    void place_nodes()
    {
      for (unsigned int i = 0; i < X.size(); ++i)
        X[i] = Point2(4. * i / (X.size() - 1.), 0.);
    }
  };

  /// Displacements: moved along by @p slip, down by @p depth at the start and @p slope more per length.
  Vector pressed(const Line &line, const double slip, const double depth, const double slope)
  {
    Vector q(line.n_contact_dofs());
    for (unsigned int i = 0; i < line.X.size(); ++i)
    {
      q[2 * i] = slip;
      q[2 * i + 1] = -depth - slope * line.X[i][0];
    }
    return q;
  }

  /// A pressure that follows the penetration.
  const Entries contact{"Penalty rule=constant",
                        "Continuation=false",
                        "Penalty factor=1e3",
                        "Penalty factor is=per area",
                        "Tangential factor=2000"};

  /// Almost flat, but not for FlatEdges.
  const Entries arched{"Shape=circle", "Radius=1e5", "Side=bottom", "Position z=-1e5", "Friction coefficient=.3"};
  const Entries plate{"Shape=plate", "Side=bottom", "Position z=0", "Across the axis=true", "Friction coefficient=.3"};

  struct Refined
  {
    /// Touch, slide by @p slip with the slope, and refine.
    Refined(const Entries &tool, const double slip, const double depth, const double slope)
      : line(3), fixture(line, contact, tool)
    {
      const Vector start = pressed(line, 0., depth, slope), q = pressed(line, slip, depth, slope);
      fixture.contact.begin_stage(start, 0.);
      for (const double time : {.5, 1.})
      {
        const Vector &now = time < 1. ? start : q;
        fixture.begin_increment(start, time, stiffness);
        fixture.converge(now);
        fixture.contact.commit(now);
      }
      old = fixture.contact.committed();
      line.halve();
      fixture.contact.transfer(pressed(line, slip, depth, slope), Line::origins(3));
    }

    Line line;
    InterfaceFixture fixture;
    std::vector<ContactPointState> old;
  };

  double place(const unsigned int i, const unsigned int n_edges)
  {
    return 4. / n_edges * (i / 4 + places[i % 4]);
  }

  double total(const std::vector<ContactPointState> &points, double ContactPointState::*const member)
  {
    double sum = 0.;
    for (const auto &state : points)
      sum += state.*member;
    return sum;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(refined_points)

BOOST_AUTO_TEST_CASE(pressures_factors_and_friction_are_those_of_the_place)
{
  const Refined blank(arched, .02, 2e-3, 1e-3);
  const auto &points = blank.fixture.contact.committed();
  BOOST_TEST_REQUIRE(points.size() == 24u);
  // By linear interpolation between the old points, of what they have per area.
  const auto there = [&](const unsigned int i, double ContactPointState::*const member) {
    const auto [a, b, share] = Line::origins(3)[i];
    return (1. - share) * blank.old[a].*member / blank.old[a].area + share * blank.old[b].*member / blank.old[b].area;
  };
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    const ContactPointState &state = points[i];
    BOOST_TEST(state.touching);
    BOOST_TEST(!state.sticking); // all of the old ones slide
    BOOST_TEST(state.area == weights[i % 4] * 4. / 6., boost::test_tools::tolerance(1e-14));
    for (const auto member : {&ContactPointState::force,
                              &ContactPointState::penalty_factor,
                              &ContactPointState::tangential_force,
                              &ContactPointState::tangential_factor})
      BOOST_TEST((state.*member) / state.area == there(i, member), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(state.force > 0.);
    BOOST_TEST(std::abs(state.tangential_force) > 0.);
    // Between the outermost points the penetration is as linear as it was, but for the arch.
    const double x = place(i, 6);
    if (i > 0 && i + 1 < points.size())
      BOOST_TEST(state.penetration() == 2e-3 + 1e-3 * x - .5e-5 * (x + .02) * (x + .02),
                 boost::test_tools::tolerance(1e-4));
    BOOST_TEST(state.slip == blank.old[0].slip, boost::test_tools::tolerance(.05));
  }
  for (const auto member : {&ContactPointState::force, &ContactPointState::tangential_force})
    BOOST_TEST(total(points, member) == total(blank.old, member), boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(contact_ends_where_it_ended)
{
  // Out of the tool from 2.1 on.
  const Refined blank(arched, .02, 2.1e-3, -1e-3);
  const auto &points = blank.fixture.contact.committed();
  unsigned int n_touching = 0;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    const auto [a, b, share] = Line::origins(3)[i];
    BOOST_TEST(points[i].touching == blank.old[share > .5 ? b : a].touching, "point " << i);
    n_touching += points[i].touching;
    if (points[i].touching)
      BOOST_TEST(points[i].force > 0.);
    else
      BOOST_TEST(points[i].force == 0.);
  }
  BOOST_TEST(n_touching > 8u);
  BOOST_TEST(n_touching < 16u);
}

BOOST_AUTO_TEST_CASE(halves_of_a_flat_edge_are_flat)
{
  const Refined blank(plate, .02, 2e-3, 1e-3);
  const auto &points = blank.fixture.contact.committed();
  BOOST_TEST(blank.old[0].area == 2. / 3., boost::test_tools::tolerance(1e-14)); // half of the edge
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    const bool outermost = i % 4 == 0 || i % 4 == 3;
    BOOST_TEST(points[i].touching == outermost);
    BOOST_TEST(points[i].area == (outermost ? 1. / 3. : 0.), boost::test_tools::tolerance(1e-14));
  }
  for (const auto member :
       {&ContactPointState::force, &ContactPointState::tangential_force, &ContactPointState::penalty_factor})
    BOOST_TEST(total(points, member) == total(blank.old, member), boost::test_tools::tolerance(.01));
}

BOOST_AUTO_TEST_SUITE_END()
