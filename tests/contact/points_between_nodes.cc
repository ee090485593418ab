// Contact points that several nodes carry: residual and tangent with friction, stiffness, what a node feels of them.
#include "fake_surface.h"

#include <deltaform/contact/contact_measures.h>
#include <deltaform/contact/deepest_place.h>
#include <deltaform/parameters/registry.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double stiffness = 1e3;

  /// Two nodes with rotations and a cubic between them, in powers of xi, with points at .2 and .7.
  class FakeBeam : public ContactSurface
  {
  public:
    unsigned int n_contact_dofs() const override
    {
      return 6;
    }

    unsigned int n_nodes() const override
    {
      return 2;
    }

    unsigned int n_contact_points(Side) const override
    {
      return places.size();
    }

    double modulus() const override
    {
      return 1e3;
    }

    double flow_stress(Side, unsigned int) const override
    {
      return .3;
    }

    void contact_point(const Vector &q,
                       const Side side,
                       const unsigned int i,
                       const ContactThickness thickness,
                       ContactPoint &point) const override
    {
      contact_place(q, side, 0, places[i], thickness, point);
      point.area = areas[i];
      point.compliance = 1e-4;
    }

    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side) const override
    {
      return edges;
    }

    unsigned int points_per_edge() const override
    {
      return places.size();
    }

    void contact_place(const Vector &q,
                       Side,
                       unsigned int,
                       const double xi,
                       ContactThickness,
                       ContactPoint &point) const override
    {
      const double x2 = xi * xi, x3 = x2 * xi;
      const std::array<double, 2> N{{1. - 3. * x2 + 2. * x3, 3. * x2 - 2. * x3}},
        H{{length * (xi - 2. * x2 + x3), length * (x3 - x2)}};
      point = ContactPoint();
      point.n_nodes = 2;
      point.n_dofs = 6;
      point.offset = .05;
      point.thickness = .1;
      for (unsigned int a = 0; a < 2; ++a)
      {
        point.nodes[a] = {a, a == 0 ? 1. - xi : xi};
        const double theta = q[3 * a + 2];
        const Tensor1 t({std::cos(theta), std::sin(theta)});
        for (unsigned int c = 0; c < 3; ++c)
          point.dofs[3 * a + c] = 3 * a + c;
        point.x += N[a] * (X[a] + Tensor1({q[3 * a], q[3 * a + 1]})) + H[a] * t;
        point.jacobian[3 * a] = Tensor1({N[a], 0.});
        point.jacobian[3 * a + 1] = Tensor1({0., N[a]});
        point.jacobian[3 * a + 2] = H[a] * Tensor1({-t[1], t[0]});
        point.second[3 * a + 2] = -H[a] * t;
      }
    }

    std::array<Tensor1, 2> X{{Tensor1({-.4, 0.}), Tensor1({.4, 0.})}};
    double length = .9;
    std::vector<double> places{.2, .7}, areas{.5, .3};
    std::vector<std::array<unsigned int, 3>> edges{{{0, 1, invalid_index}}};
  };

  /// The same one that says how far it moves; counts how often it is described, and how often only located.
  class CountingBeam : public FakeBeam
  {
  public:
    void contact_point(const Vector &q,
                       const Side side,
                       const unsigned int i,
                       const ContactThickness thickness,
                       ContactPoint &point) const override
    {
      ++n;
      FakeBeam::contact_point(q, side, i, thickness, point);
    }

    void locate_point(const Vector &q,
                      const Side side,
                      const unsigned int i,
                      const ContactThickness thickness,
                      ContactPoint &point) const override
    {
      ++n_located;
      FakeBeam::contact_point(q, side, i, thickness, point);
      // Nobody may ask for these.
      point.jacobian.fill(Tensor1({1e9, -1e9}));
      point.n_dofs = 0;
    }

    double largest_motion(Side, unsigned int, const std::array<double, ContactPoint::max_dofs> &change) const override
    {
      return std::max(std::hypot(change[0], change[1]), std::hypot(change[3], change[4])) +
             4. / 27. * length * (std::abs(change[2]) + std::abs(change[5]));
    }

    mutable unsigned int n = 0, n_located = 0;
  };

  const Entries circle{"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"};

  /// Both points in a circle of radius 1, by about @p depth.
  Vector pressed(const InterfaceFixture &fixture, const double slip, const double depth)
  {
    Vector q(fixture.n);
    q[1] = q[4] = .964 - depth;
    q[0] = q[3] = slip;
    q[2] = .35;
    q[5] = -.4;
    if (fixture.settings.normal_law->has_multiplier())
      q[6] = q[7] = 1.5;
    return q;
  }

  /// Of a beam that has slid by @p slip since the last increment, or sticks.
  void check_tangent(const std::string &law, const double slip, const Entries &tool)
  {
    FakeBeam beam;
    InterfaceFixture fixture(beam, {"Enforcement=" + law, "Tangential factor=20"}, circle + tool);
    const Vector before = pressed(fixture, slip, 0.), q = pressed(fixture, 0., .005);
    fixture.contact.begin_stage(before, 0.);
    fixture.begin_increment(before, .5, stiffness);
    fixture.converge(before);
    fixture.contact.commit(before);
    fixture.begin_increment(before, 1., stiffness);
    fixture.converge(q);
    BOOST_TEST(fixture.contact.n_touching() == 2u);
    if (fixture.contact.friction() != nullptr)
      for (const auto &state : fixture.contact.trial())
        BOOST_TEST(state.sticking == (slip < .1));
    // Estimates of lambda are the forces wherever the residual is asked, as in equilibrium.
    const bool follow = !fixture.settings.normal_law->has_multiplier();
    const Assembly assembly = [&](const Vector &state, AssemblyTarget &target) {
      if (follow)
        fixture.converge(state);
      fixture.contact.assemble(state, target);
    };
    BOOST_TEST(tangent_error(assembly, q, std::vector<double>(fixture.n, 1.), 1e-5) < 1e-7);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(points_between_nodes)

BOOST_AUTO_TEST_CASE(tangent)
{
  for (const auto &law : Registry<NormalLaw>::names())
    for (const std::string drive : {"Motion=0", "Force=3"})
      for (const double slip : {5e-4, .3})
        BOOST_TEST_CONTEXT(law << ", " << drive << ", slip " << slip)
  check_tangent(law, slip, {"Friction coefficient=.3", drive});
}

BOOST_AUTO_TEST_CASE(tangent_of_shared_friction)
{
  // The friction of one point depends on the force of the other where the law asks for the pressure. Forces that are
  // unknowns (active set) share without being coupled.
  for (const auto &friction : Registry<FrictionLaw>::names())
    for (const std::string law : {"penalty", "adaptive compensated", "augmented Lagrangian"})
      for (const std::string drive : {"Motion=0", "Force=3"})
        BOOST_TEST_CONTEXT(friction << ", " << law << ", " << drive)
        {
          const Entries entries = documented_entries([&](ParameterTree &tree) {
            Section section = tree.root();
            Registry<FrictionLaw>::make(friction, section);
          });
          check_tangent(law, .3, entries + Entries{"Friction law=" + friction, drive});
        }
}

BOOST_AUTO_TEST_CASE(stiffness_of_a_point)
{
  // c^T K c with K = k 1: k times the square of the row, of which the normal is the common factor.
  FakeBeam beam;
  beam.X = {{Tensor1({.2, 0.}), Tensor1({1., 0.})}};
  InterfaceFixture fixture(beam, {}, flat);
  Vector q(fixture.n);
  q[1] = q[4] = .049; // flat on the plate, .001 in it
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  for (unsigned int i = 0; i < 2; ++i)
  {
    const double x = beam.places[i], y = 1. - x;
    const double square = std::pow(y * y * (1. + 2. * x), 2) + std::pow(x * x * (1. + 2. * y), 2) +
                          beam.length * beam.length * (std::pow(x * y * y, 2) + std::pow(x * x * y, 2));
    BOOST_TEST(fixture.contact.trial()[i].stiffness == stiffness * square, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(nodes_feel_the_forces_of_their_points)
{
  FakeBeam beam;
  beam.X = {{Tensor1({.2, 0.}), Tensor1({1., 0.})}};
  InterfaceFixture fixture(beam, {"Penalty rule=constant", "Continuation=false", "Penalty factor=50"}, flat);
  Vector q(fixture.n);
  q[1] = q[4] = .049;
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  const DenseTarget target = fixture.converge(q);
  fixture.contact.commit(q);
  const auto &points = fixture.contact.committed();
  const double first = points[0].force, second = points[1].force;
  BOOST_TEST(first > 0.);
  BOOST_TEST(target.residual[1] + target.residual[4] == -first - second, boost::test_tools::tolerance(1e-13));
  // Of every node: its shares of the forces over those of the areas.
  const auto pressure = contact_pressure(fixture.contact, fixture.contact.committed(), q, 2);
  BOOST_TEST(pressure[0] == (.8 * first + .3 * second) / (.8 * .5 + .3 * .3), boost::test_tools::tolerance(1e-13));
  BOOST_TEST(pressure[1] == (.2 * first + .7 * second) / (.2 * .5 + .7 * .3), boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(edges_that_are_clear_are_left_alone_and_nothing_changes)
{
  // Down to the circle, in, and up again, by steps of Newton's method that are foreseen and taken.
  FakeBeam plain;
  CountingBeam counting;
  std::array<std::unique_ptr<InterfaceFixture>, 2> fixtures;
  for (const unsigned int k : {0, 1})
    fixtures[k] = std::make_unique<InterfaceFixture>(
      k == 0 ? plain : static_cast<FakeBeam &>(counting),
      Entries{},
      circle + Entries{"Friction coefficient=.3", "Motion=.2*t"});
  Vector q = pressed(*fixtures[0], 0., 0.);
  q[1] = q[4] = 1.52;
  for (auto &fixture : fixtures)
    fixture->contact.begin_stage(q, 0.);
  unsigned int n_touched = 0, n_described = 0, n_located = 0;
  for (unsigned int increment = 1; increment <= 40; ++increment)
  {
    for (auto &fixture : fixtures)
      fixture->begin_increment(q, .025 * increment, stiffness);
    for (unsigned int iteration = 0; iteration < 3; ++iteration)
    {
      const unsigned int n_before = counting.n, n_located_before = counting.n_located;
      std::array<DenseTarget, 2> targets{{fixtures[0]->assemble(q), fixtures[1]->assemble(q)}};
      n_described += counting.n - n_before;
      n_located += counting.n_located - n_located_before;
      for (unsigned int i = 0; i < targets[0].residual.size(); ++i)
        BOOST_TEST(targets[0].residual[i] == targets[1].residual[i]);
      Vector d(fixtures[0]->n);
      for (const unsigned int node : {0, 1})
      {
        d[3 * node] = .001 * (1. + node);
        d[3 * node + 1] = increment < 25 ? -.009 : .015;
        d[3 * node + 2] = node == 0 ? .004 : -.003;
      }
      BOOST_TEST(fixtures[0]->contact.foresee(q, d) == fixtures[1]->contact.foresee(q, d));
      for (auto &fixture : fixtures)
      {
        fixture->contact.prepare_step(d);
        fixture->contact.advance(1.);
      }
      q += d;
    }
    for (auto &fixture : fixtures)
    {
      fixture->assemble(q);
      fixture->contact.commit(q);
    }
    n_touched += fixtures[0]->contact.n_touching();
    for (unsigned int i = 0; i < 2; ++i)
    {
      const ContactPointState &a = fixtures[0]->contact.committed()[i], &b = fixtures[1]->contact.committed()[i];
      BOOST_TEST(a.touching == b.touching);
      BOOST_TEST(a.gap == b.gap);
      BOOST_TEST(a.force == b.force);
      BOOST_TEST(a.tangential_force == b.tangential_force);
      BOOST_TEST(a.position.distance(b.position) == 0.);
    }
  }
  BOOST_TEST(n_touched > 10u);
  BOOST_TEST(n_touched < 60u);
  // There were 240 points to be looked at. What is clear is located, and needs no row.
  BOOST_TEST(n_described < 120u);
  BOOST_TEST(n_located < 80u);
}

BOOST_AUTO_TEST_CASE(the_deepest_place_is_found_between_the_points)
{
  // A straight line over a circle: deepest in the middle, where no point lies.
  FakeBeam beam;
  beam.length = .8;
  InterfaceFixture fixture(beam, {}, circle);
  Vector q(fixture.n);
  const double depth = .005;
  q[1] = q[4] = 1. + .05 - depth;
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(fixture.contact.n_touching() == 0u);
  BOOST_TEST(penetration_between_nodes(fixture.contact, q) == 0.); // no point has noticed the tool
  beam.places = {.45, .7};
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(fixture.contact.n_touching() == 1u);
  const auto &state = fixture.contact.committed()[0];
  // The face is squeezed where it touches; half as much in the middle.
  BOOST_TEST(penetration_between_nodes(fixture.contact, q) == depth - .5e-4 * state.force,
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(penetration_between_nodes(fixture.contact, q) > state.penetration());
}

BOOST_AUTO_TEST_SUITE_END()
