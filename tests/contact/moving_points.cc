// Contact points that move along their edges to where they are deepest.
#include "../blanks/any_blank.h"
#include "fake_surface.h"

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double h = .02, R = .3, stiffness = 1e3, tilt = .6;
  const Point2 center(.6, -.3); // of the arc of the die

  const Entries die{"Shape=die", "Throat radius=.3", "Profile radius=.3", "Side=bottom", "Position z=0", "Thickness compliance=off"};
  const Entries constant{"Penalty rule=constant", "Continuation=false", "Penalty factor=50", "Allowed penetration=1e-4"};

  /// A strip from 0 to 1 of eight elements.
  std::unique_ptr<Blank> strip()
  {
    return make_blank("shell",
                      {"Blank/Points=0 0; 1 0",
                       "Blank/Thickness=.02",
                       "Blank/Symmetry=plane strain",
                       "Blank/Elements=8",
                       "Blank/Contact points=moving",
                       "Material/Young's modulus=2e3"});
  }

  /// The strip, still straight, on the arc: it touches a length @p s from its start, @p depth deep.
  Vector tilted(const Blank &blank, const unsigned int n, const double s, const double depth)
  {
    Vector q(n);
    const Tensor1 along({std::cos(tilt), std::sin(tilt)}), normal({-std::sin(tilt), std::cos(tilt)});
    const Point2 start = center + (R + .5 * h - depth) * normal - s * along;
    const Vector zero(n);
    const auto places = blank.positions(zero);
    for (unsigned int e = 0; e < 8; ++e)
    {
      ContactPoint point;
      blank.surface().contact_place(zero, Side::bottom, e, 0., ContactThickness::current, point);
      for (unsigned int a = 0; a < 2; ++a)
      {
        const Point2 &X = places[point.nodes[a].node];
        const Tensor1 u = start + X[0] * along - X;
        q[point.dofs[3 * a]] = u[0];
        q[point.dofs[3 * a + 1]] = u[1];
        q[point.dofs[3 * a + 2]] = tilt;
      }
    }
    return q;
  }

  struct OnArc
  {
    explicit OnArc(const Entries &tool = {}, const double s = .4)
      : blank(strip()), fixture(blank->surface(), constant, die + tool), q(tilted(*blank, fixture.n, s, 1e-3))
    {
      fixture.contact.begin_stage(q, 0.);
      fixture.begin_increment(q, 1., stiffness);
      fixture.converge(q);
    }

    const MovingPoints &moving() const
    {
      return fixture.contact.projector().moving();
    }

    std::unique_ptr<Blank> blank;
    InterfaceFixture fixture;
    Vector q;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(moving_points)

BOOST_AUTO_TEST_CASE(it_is_where_the_gap_is_least)
{
  OnArc on;
  BOOST_TEST(on.fixture.contact.n_touching() == 1u);
  const auto &points = on.fixture.contact.trial();
  BOOST_TEST(points[3].touching); // of .375 to .5
  // g' of the straight edge is u/rho times its length L, u from the foot of the normal: c (xi - 1/2) moves it.
  const double L = .125, foot = (.4 - .375) / L;
  const double xi = on.moving().place(3), c = 8. * on.moving().lift(3, .5);
  const double u = (xi - foot) * L, rho = std::hypot(R + .5 * h - 1e-3, u);
  BOOST_TEST(std::abs(L * u / rho + c * (xi - .5)) < 1e-12);
  BOOST_TEST(c < .11 * L * L / R); // a tenth of the arc's curvature
  // Contact sees the gap less the lift.
  BOOST_TEST(std::abs(points[3].gap - (rho - R - .5 * h - on.moving().lift(3, xi))) < 1e-12);
  // At its ends an edge has no lift, and neighbours have the same gap.
  BOOST_TEST(on.moving().lift(3, 0.) == 0.);
  BOOST_TEST(on.moving().lift(3, 1.) == 0.);
  BOOST_TEST(on.moving().place(2) == 1.);
  BOOST_TEST(on.moving().place(4) == 0.);
  BOOST_TEST(on.moving().beyond(2) == 3u);
  BOOST_TEST(on.moving().beyond(4) == 3u);
  BOOST_TEST(on.moving().beyond(3) == invalid_index);
}

BOOST_AUTO_TEST_CASE(tangent)
{
  for (const std::string drive : {"Motion=0", "Force=3"})
  {
    OnArc on({drive});
    const Assembly assembly = [&](const Vector &state, AssemblyTarget &target) {
      on.fixture.converge(state);
      on.fixture.contact.assemble(state, target);
    };
    BOOST_TEST(tangent_error(assembly, on.q, std::vector<double>(on.fixture.n, 1.), 1e-6) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(it_goes_on_in_the_next_edge)
{
  // The strip slides by less than an edge: the force goes to the next point, and is what a fresh one would have.
  OnArc on;
  const double force = on.fixture.contact.trial()[3].force;
  BOOST_TEST(force > 0.);
  on.fixture.contact.commit(on.q);
  on.fixture.begin_increment(on.q, 2., stiffness);
  const Vector there = tilted(*on.blank, on.fixture.n, .4 - .125, 1e-3);
  on.fixture.converge(there);
  const auto &points = on.fixture.contact.trial();
  BOOST_TEST(on.fixture.contact.n_touching() == 1u);
  BOOST_TEST(points[2].touching);
  BOOST_TEST(points[2].force == force, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(std::abs(on.moving().place(2) - .2) < .05);
}

BOOST_AUTO_TEST_CASE(slip_is_that_of_the_sheet)
{
  // The strip goes .01 along itself: the point stays where it is over the tool, and the slip is the way of the strip
  // along the tool, as that of a sheet that follows the arc.
  const double way = .01;
  OnArc on({"Friction coefficient=.1"});
  on.fixture.contact.commit(on.q);
  const double place = on.moving().place(3);
  on.fixture.begin_increment(on.q, 2., stiffness);
  const Vector there = tilted(*on.blank, on.fixture.n, .4 - way, 1e-3);
  on.fixture.converge(there);
  on.fixture.contact.commit(there);
  BOOST_TEST(on.moving().place(3) < place - .9 * way / .125 / 1.1);
  BOOST_TEST(on.fixture.contact.committed()[3].slip == way * R / (R + .5 * h), boost::test_tools::tolerance(1e-2));
  // A smooth face that touches has no slope but that of c.
  BOOST_TEST(std::abs(on.fixture.contact.committed()[3].slope) < .05);
}

BOOST_AUTO_TEST_CASE(it_rests_over_a_straight_part)
{
  OnArc on;
  Vector flat(on.fixture.n);
  const auto places = on.blank->positions(flat);
  for (unsigned int e = 0; e < 8; ++e)
  {
    ContactPoint point;
    on.blank->surface().contact_place(Vector(on.fixture.n), Side::bottom, e, 0., ContactThickness::current, point);
    for (unsigned int a = 0; a < 2; ++a)
    {
      flat[point.dofs[3 * a]] = .7;
      flat[point.dofs[3 * a + 1]] = .5 * h - 1e-4;
    }
  }
  InterfaceFixture fixture(on.blank->surface(), constant, die);
  fixture.contact.begin_stage(flat, 0.);
  fixture.begin_increment(flat, 1., stiffness);
  fixture.converge(flat);
  BOOST_TEST(fixture.contact.n_touching() == 8u);
  for (unsigned int e = 0; e < 8; ++e)
  {
    BOOST_TEST(fixture.contact.projector().moving().place(e) == .5);
    BOOST_TEST(fixture.contact.projector().moving().lift(e, .5) == 0.);
  }
}

BOOST_AUTO_TEST_SUITE_END()
