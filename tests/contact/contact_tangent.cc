// Residual and tangent of a contact point on lines, arcs and corners of every registered shape, with every registered
// enforcement: sticking, slipping, on both sides, for tools that are moved and tools that are driven by a force.
#include "fake_surface.h"

#include <deltaform/geometry/curvature.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <tuple>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  // Convex and concave arcs between lines.
  struct Wave : Shape
  {
    explicit Wave(Section &)
    {
      build({{-1., .4}, {0., 0.}, {1., .9}, {2., -.4}}, {0., .6, .5, 0.});
    }
  };
  // The example of the recipe for a new shape: the tip is half a corner on the axis.
  struct Cone : Shape
  {
    explicit Cone(Section &)
    {
      build({{0., 0.}, {1., -.5}, {1., -2.5}}, {0., .1, 0.}, End::axis, End::endless);
    }
  };
  const Registry<Shape>::Entry cone("cone (test)", "A tip, a line, a fillet and a wall", make_as<Cone, Shape>);
  const Registry<Shape>::Entry wave("wave (test)", "Lines, a convex and a concave fillet", make_as<Wave, Shape>);

  constexpr double offset = .05, stiffness = 1e3;

  /// A place of a node on the tool; the number says how it penetrates and slips.
  struct Place
  {
    Point2 closest;
    Tensor1 normal;
    unsigned int number;
  };

  /// Where contact may be: on every line, arc and outer corner of a tool, and the normal there, in the scene's frame.
  /// @p near_corners: also where a node without an offset would be on the other side of one
  std::vector<Place> places(const Tool &tool, const bool near_corners)
  {
    std::vector<Place> result;
    const double mirror = tool.side() == Side::top && !tool.shape().in_scene_frame() ? -1. : 1.;
    for (const auto &segment : tool.shape().segments())
      for (const double part : {.003, .03, .3, .6})
      {
        if (!near_corners && part < .01)
          continue;
        Point2 closest;
        Tensor1 normal;
        if (segment.kind == Segment::Kind::line)
        {
          closest = segment.start + part * (segment.end - segment.start);
          normal = Tensor1({-segment.tangent[1], segment.tangent[0]});
        }
        else
        {
          const double angle = segment.angle_start + part * segment.sweep;
          normal = Tensor1({std::cos(angle), std::sin(angle)});
          closest = segment.center + segment.radius * normal;
          if (!segment.convex)
            normal *= -1.;
          if (!segment.convex && segment.radius < 3 * offset)
            continue; // a dent
        }
        closest[1] *= mirror;
        normal[1] *= mirror;
        const Projection p = tool.project(closest + offset * normal, 0.);
        if (std::abs(p.distance - offset) < 1e-12 && (p.normal - normal).norm() < 1e-9)
          result.push_back({closest, normal, static_cast<unsigned int>(result.size())});
      }
    return result;
  }

  struct Variant
  {
    double arm; // of the rotation; 0: no rotation
    double slip; // of every node along the tool since it touched
    std::string drive; // entry of the tool
    std::string enforcement; // registered
    bool second; // in the second increment of contact, from a state with friction
    std::string law = "coulomb"; // of friction, registered
  };

  using Branch = std::tuple<bool, bool, unsigned int, double>;

  /// Nodes at places of a tool, penetrating by p, after a slip.
  struct Placed
  {
    Placed(const std::vector<Place> &where, const Variant &what, const Entries &contact, const Entries &entries)
      : surface(where.size(), what.arm, what.arm > 0. ? 0. : offset), fixture(surface, contact, entries), q(fixture.n),
        before(fixture.n)
    {
      surface.yield = .3;
      for (unsigned int i = 0; i < where.size(); ++i)
        put(i, where[i], what);
      fixture.contact.begin_stage(before, 0.);
      if (what.second)
      {
        fixture.begin_increment(before, .5, stiffness);
        fixture.converge(before);
        fixture.contact.commit(before);
      }
      fixture.begin_increment(before, 1., stiffness);
      fixture.converge(q);
    }

    void put(const unsigned int i, const Place &place, const Variant &what)
    {
      const auto &[closest, normal, number] = place;
      const Tensor1 tangent({normal[1], -normal[0]});
      const bool own_unknown = fixture.settings.normal_law->has_multiplier();
      const unsigned int first = i * surface.dofs_per_node();
      // The contact point lies off the tool by the offset: x = X + u (+ arm d). Nodes differ in penetration.
      const double p = number % 3 == 2 && own_unknown ? -.01 : 4e-3 + 1e-3 * (number % 5);
      Tensor1 contact_point = closest + (surface.offset - p) * normal;
      if (what.arm > 0.)
      {
        const double theta = .3 + .1 * number, a = fixture.tool.side() == Side::top ? what.arm : -what.arm;
        contact_point -= a * Tensor1({-std::sin(theta), std::cos(theta)});
        q[first + 2] = before[first + 2] = theta;
      }
      surface.X[i] = Point2(contact_point);
      const double slip = what.slip * (number % 2 == 0 ? 1. : -1.);
      const Tensor1 from = (what.second ? 0. : .02) * normal - slip * tangent;
      for (unsigned int k = 0; k < 2; ++k)
        before[first + k] = from[k];
      if (own_unknown)
        q[fixture.n_blank + i] = before[fixture.n_blank + i] =
          number % 6 == 5 ? .01 : 1. + .1 * number; // tension: not tied
    }

    /// What decides how a node's forces depend on its place: where it changes they have a kink.
    std::vector<Branch> branches(const Vector &state)
    {
      fixture.assemble(state, false);
      const Tensor1 shift = fixture.contact.travel(state) * fixture.tool.direction();
      const Shape &shape = fixture.tool.shape();
      std::vector<Branch> result;
      for (unsigned int i = 0; i < fixture.contact.n_points(); ++i)
      {
        const ContactPointState &point = fixture.contact.trial()[i];
        const auto closest = fixture.tool.project(fixture.contact.point(state, i).x - shift, 0.);
        result.emplace_back(point.touching,
                            point.sticking,
                            closest.segment,
                            surface.offset > 0. ? curvature_change(shape, closest.arc_length, surface.offset) +
                                                    corner_share(shape, closest.arc_length, surface.offset).slope
                                                : 0.);
      }
      return result;
    }

    /// Nodes that stay on the same branch wherever a step of length @p h takes one unknown.
    std::vector<bool> is_smooth(const double h)
    {
      const auto here = branches(q);
      std::vector<bool> smooth(here.size(), true);
      for (unsigned int k = 0; k < fixture.n; ++k)
        for (const double sign : {-1., 1.})
        {
          Vector moved = q;
          moved[k] += sign * h;
          const auto there = branches(moved);
          for (unsigned int i = 0; i < here.size(); ++i)
            smooth[i] = smooth[i] && here[i] == there[i];
        }
      return smooth;
    }

    FakeSurface surface;
    InterfaceFixture fixture;
    Vector q, before;
  };

  /// Compare tangent and residual's differences at nodes all over the tool. Where a node touches, sticks or meets
  /// another part of the tool within the step of the differences there is no tangent: such nodes are left out.
  void check(const std::string &shape, const std::string &side, const Variant &what)
  {
    constexpr double step = 1e-5;
    // Entries of the documentation of shape and law
    Entries entries = documented_entries(
      [&](ParameterTree &tree) {
        Section section = tree.root();
        Registry<Shape>::make(shape, section);
        Registry<FrictionLaw>::make(what.law, section);
      });
    entries = entries + Entries{"Shape=" + shape,
                                "Side=" + side,
                                "Position z=0",
                                "Friction law=" + what.law,
                                "Friction coefficient=.3",
                                what.drive};
    const Entries contact{"Enforcement=" + what.enforcement, "Tangential factor=20"};
    const auto all = places(InterfaceFixture(FakeSurface(1), contact, entries).tool, what.arm == 0.);
    BOOST_TEST_REQUIRE(all.size() > 0u);

    std::vector<Place> where;
    const auto smooth = Placed(all, what, contact, entries).is_smooth(2 * step);
    for (unsigned int i = 0; i < all.size(); ++i)
      if (smooth[i])
        where.push_back(all[i]);
    BOOST_TEST_REQUIRE(4 * where.size() >= 3 * all.size());

    Placed placed(where, what, contact, entries);
    InterfaceFixture &fixture = placed.fixture;
    unsigned int touching = 0, sliding = 0;
    for (const auto &state : fixture.contact.trial())
    {
      touching += state.touching;
      sliding += state.touching && !state.sticking;
    }
    BOOST_TEST(touching > 0u);
    BOOST_TEST((what.slip < 1e-2 || sliding > 0u || !fixture.contact.friction()));
    BOOST_TEST((what.slip > 1e-2 || sliding < touching));
    const Assembly assembly = [&](const Vector &state, AssemblyTarget &target) {
      fixture.contact.assemble(state, target);
    };
    BOOST_TEST(tangent_error(assembly, placed.q, std::vector<double>(fixture.n, 1.), step) < 1e-7);
  }

  void for_all_shapes(const Variant &variant)
  {
    for (const auto &shape : Registry<Shape>::names())
      for (const std::string side : {"bottom", "top"})
        BOOST_TEST_CONTEXT("shape '" << shape << "', side " << side << ", arm " << variant.arm << ", slip "
                                     << variant.slip << ", " << variant.drive << ", second " << variant.second)
    check(shape, side, variant);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(contact_tangent)

BOOST_AUTO_TEST_CASE(moved_tools)
{
  for (const auto &enforcement : Registry<NormalLaw>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
  for (const double arm : {0., .05})
    for (const double slip : {5e-4, .03})
      for (const bool second : {false, true})
        for_all_shapes({arm, slip, "Motion=0", enforcement, second});
}

BOOST_AUTO_TEST_CASE(laws_of_friction)
{
  for (const auto &law : Registry<FrictionLaw>::names())
    for (const std::string enforcement : {"penalty", "active set"})
      BOOST_TEST_CONTEXT("friction law '" << law << "', enforcement '" << enforcement << "'")
  for (const double slip : {5e-4, .03})
    for_all_shapes({.05, slip, "Motion=0", enforcement, true, law});
}

BOOST_AUTO_TEST_CASE(force_driven_tools)
{
  for (const auto &enforcement : Registry<NormalLaw>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
  for (const double slip : {5e-4, .03})
    for_all_shapes({.05, slip, "Force=3", enforcement, true});
}

BOOST_AUTO_TEST_CASE(contact_that_is_soft)
{
  for (const auto &enforcement : Registry<NormalLaw>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
    {
      FakeSurface surface(3, 0., offset);
      surface.X = {{-.4, offset - .01}, {.1, offset - .02}, {.7, offset - .01}};
      InterfaceFixture fixture(surface, {"Enforcement=" + enforcement}, flat + Entries{"Friction coefficient=.1"});
      Vector q(fixture.n);
      for (unsigned int i = fixture.n_blank; i < fixture.n; ++i)
        q[i] = .5;
      fixture.contact.begin_stage(q, 0.);
      const Assembly assembly = [&](const Vector &state, AssemblyTarget &target) {
        fixture.contact.assemble(state, target);
      };
      // First touches, and points that touch already.
      for (const double time : {1., 2.})
      {
        fixture.begin_increment(q, time, stiffness);
        fixture.contact.soften(1e-2);
        fixture.converge(q);
        BOOST_TEST(tangent_error(assembly, q, std::vector<double>(fixture.n, 1.), 1e-5) < 1e-7);
        fixture.contact.commit(q);
      }
    }
}

BOOST_AUTO_TEST_CASE(frictionless_forces_have_a_potential)
{
  FakeSurface surface(2, .05);
  surface.X = {{.1, 1.}, {.8, .6}};
  InterfaceFixture fixture(
    surface, {"Enforcement=penalty"}, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"});
  Vector q(fixture.n);
  q[2] = .1;
  q[5] = -.5;
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  const auto target = fixture.converge(q);
  BOOST_TEST((target.matrix - target.matrix.transpose()).norm() < 1e-13 * target.matrix.norm());
  const auto potential = [&](const Vector &state) {
    fixture.assemble(state);
    double sum = 0.;
    for (const auto &point : fixture.contact.trial())
      sum += .5 * point.penalty_factor * point.gap * point.gap;
    return sum;
  };
  constexpr double h = 1e-5;
  BOOST_TEST(target.residual.norm() > 0.);
  for (unsigned int i = 0; i < fixture.n; ++i)
  {
    Vector plus = q, minus = q;
    plus[i] += h;
    minus[i] -= h;
    BOOST_TEST(std::abs((potential(plus) - potential(minus)) / (2. * h) - target.residual[i]) <
               1e-8 * target.residual.norm());
  }
}

BOOST_AUTO_TEST_CASE(the_tool_feels_the_opposite_force)
{
  FakeSurface surface(2, .05);
  surface.X = {{.1, 1.}, {.8, .6}};
  const Entries circle{
    "Shape=circle", "Radius=1", "Side=bottom", "Position z=0", "Friction coefficient=.2", "Force=2", "Direction=3 4"};
  InterfaceFixture fixture(surface, {"Enforcement=penalty"}, circle);
  Vector q(fixture.n), before = q;
  before[0] = .01;
  fixture.contact.begin_stage(before, 0.);
  fixture.begin_increment(before, 1., stiffness);
  const auto target = fixture.converge(q);
  BOOST_TEST(fixture.contact.n_touching() == 2u);
  const Tensor1 on_nodes({-target.residual[0] - target.residual[3], -target.residual[1] - target.residual[4]});
  BOOST_TEST((fixture.contact.tool_force() + on_nodes).norm() < 1e-13);
  // The travel's row: the blank pushes back along the direction what the force pushes forward.
  const double pushed_back = -(fixture.contact.tool_force() * fixture.tool.direction());
  BOOST_TEST(std::abs(target.residual[fixture.n - 1] - (pushed_back - 2.)) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
