// Residual and tangent of a contact pair on lines, arcs and corners of every registered shape, with every registered
// enforcement: sticking, slipping, on both sides, for tools that are moved and tools that are driven by a force.
#include "fake_surface.h"

#include <deltaform/base/registry.h>

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
  const Registry<Shape>::Entry wave("wave (test)", "Lines, a convex and a concave fillet", make_as<Wave, Shape>);

  constexpr double offset = .05, stiffness = 1e3;

  /// Where contact may be: on every line, arc and outer corner of a tool, and the normal there, in the scene's frame.
  std::vector<std::pair<Point2, Tensor1>> places(const Tool &tool)
  {
    std::vector<std::pair<Point2, Tensor1>> result;
    const double mirror = tool.side() == Side::top && !tool.shape().in_scene_frame() ? -1. : 1.;
    for (const auto &segment : tool.shape().segments())
      for (const double part : {.03, .3, .6})
      {
        Point2 foot;
        Tensor1 normal;
        if (segment.kind == Shape::Segment::Kind::line)
        {
          foot   = segment.start + part * (segment.end - segment.start);
          normal = Tensor1({-segment.tangent[1], segment.tangent[0]});
        }
        else
        {
          const double angle = segment.angle_start + part * segment.sweep;
          normal             = Tensor1({std::cos(angle), std::sin(angle)});
          foot               = segment.center + segment.radius * normal;
          if (!segment.convex)
            normal *= -1.;
          if (!segment.convex && segment.radius < 3 * offset)
            continue; // a dent
        }
        foot[1] *= mirror;
        normal[1] *= mirror;
        const Projection p = tool.project(foot + offset * normal, 0.);
        if (std::abs(p.distance - offset) < 1e-12 && (p.normal - normal).norm() < 1e-9)
          result.emplace_back(foot, normal);
      }
    return result;
  }

  struct Variant
  {
    double arm;              // of the rotation; 0: no rotation
    double slip;             // of every node along the tool since it touched
    std::string drive;       // entry of the tool
    std::string enforcement; // registered
    bool second;             // in the second increment of contact, from a state with friction
  };

  /// Put a node on every place of the tool, penetrating by p, after a slip; compare tangent and residual's differences.
  void check(const std::string &shape, const std::string &side, const Variant &what)
  {
    // Entries of the shape's documentation
    Entries entries = documented_entries(
      [&](ParameterTree &tree)
      {
        Section section = tree.root();
        Registry<Shape>::make(shape, section);
      });
    entries =
      entries + Entries{"Shape=" + shape, "Side=" + side, "Position z=0", "Friction coefficient=.3", what.drive};
    const Entries contact{"Enforcement=" + what.enforcement, "Tangential factor=20"};
    const auto where = places(PairFixture(FakeSurface(1), contact, entries).tool);
    BOOST_TEST_REQUIRE(where.size() > 0u);

    FakeSurface surface(where.size(), what.arm, what.arm > 0. ? 0. : offset);
    PairFixture fixture(surface, contact, entries);
    Vector q(fixture.n), before(fixture.n);
    for (unsigned int i = 0; i < where.size(); ++i)
    {
      const auto &[foot, normal] = where[i];
      const Tensor1 tangent({normal[1], -normal[0]});
      const unsigned int first = i * surface.dofs_per_node();
      // The contact point lies off the tool by the offset: x = X + u (+ arm d). Nodes differ in penetration.
      const double p = i % 3 == 2 && fixture.settings.enforcement->has_multiplier() ? -.01 : 4e-3 + 1e-3 * (i % 5);
      Tensor1 contact_point = foot + (surface.offset - p) * normal;
      double theta          = 0.;
      if (what.arm > 0.)
      {
        theta          = .3 + .1 * i;
        const double a = side == "top" ? what.arm : -what.arm;
        contact_point -= a * Tensor1({-std::sin(theta), std::cos(theta)});
        q[first + 2] = before[first + 2] = theta;
      }
      surface.X[i] = Point2(contact_point);
      for (unsigned int k = 0; k < 2; ++k)
        before[first + k] = -what.slip * (i % 2 == 0 ? 1. : -1.) * tangent[k] + (what.second ? 0. : .02 * normal[k]);
    }
    if (fixture.settings.enforcement->has_multiplier())
      for (unsigned int i = 0; i < where.size(); ++i)
        q[fixture.n_blank + i] = before[fixture.n_blank + i] = i % 6 == 5 ? .01 : 1. + .1 * i; // tension: not tied

    fixture.pair.begin_stage(before, 0.);
    if (what.second)
    {
      fixture.begin_increment(before, .5, stiffness);
      fixture.settle(before);
      fixture.pair.commit(before);
    }
    fixture.begin_increment(before, 1., stiffness);
    fixture.settle(q);

    unsigned int touching = 0, sliding = 0;
    for (const auto &state : fixture.pair.trial())
    {
      touching += state.touching;
      sliding += state.touching && !state.sticking;
    }
    BOOST_TEST(touching > 0u);
    BOOST_TEST((what.slip < 1e-2 || sliding > 0u));
    BOOST_TEST((what.slip > 1e-2 || sliding < touching));
    const Assembly assembly = [&](const Vector &state, AssemblyTarget &target)
    { fixture.pair.assemble(state, target); };
    BOOST_TEST(tangent_error(assembly, q, std::vector<double>(fixture.n, 1.), 1e-5) < 1e-7);
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
  for (const auto &enforcement : Registry<Enforcement>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
  for (const double arm : {0., .05})
    for (const double slip : {5e-4, .03})
      for (const bool second : {false, true})
        for_all_shapes({arm, slip, "Motion=0", enforcement, second});
}

BOOST_AUTO_TEST_CASE(force_driven_tools)
{
  for (const auto &enforcement : Registry<Enforcement>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
  for (const double slip : {5e-4, .03})
    for_all_shapes({.05, slip, "Force=3", enforcement, true});
}

BOOST_AUTO_TEST_CASE(first_touches_in_continuation)
{
  for (const auto &enforcement : Registry<Enforcement>::names())
    BOOST_TEST_CONTEXT("enforcement '" << enforcement << "'")
    {
      FakeSurface surface(3, 0., offset);
      surface.X = {{-.4, offset - .01}, {.1, offset - .02}, {.7, offset - .01}};
      PairFixture fixture(surface, {"Enforcement=" + enforcement}, flat + Entries{"Friction coefficient=.1"});
      Vector q(fixture.n);
      for (unsigned int i = fixture.n_blank; i < fixture.n; ++i)
        q[i] = .5;
      fixture.pair.begin_stage(q, 0.);
      fixture.begin_increment(q, 1., stiffness);
      fixture.pair.soften(1e-2);
      fixture.settle(q);
      const Assembly assembly = [&](const Vector &state, AssemblyTarget &target)
      { fixture.pair.assemble(state, target); };
      BOOST_TEST(tangent_error(assembly, q, std::vector<double>(fixture.n, 1.), 1e-5) < 1e-7);
    }
}

BOOST_AUTO_TEST_CASE(frictionless_forces_have_a_potential)
{
  FakeSurface surface(2, .05);
  surface.X = {{.1, 1.}, {.8, .6}};
  PairFixture fixture(surface, {"Enforcement=penalty"}, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"});
  Vector q(fixture.n);
  q[2] = .1;
  q[5] = -.5;
  fixture.pair.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  const auto target = fixture.settle(q);
  BOOST_TEST((target.matrix - target.matrix.transpose()).norm() < 1e-13 * target.matrix.norm());
  const auto potential = [&](const Vector &state)
  {
    fixture.assemble(state);
    double sum = 0.;
    for (const auto &pair : fixture.pair.trial())
      sum += .5 * pair.epsilon * pair.gap * pair.gap;
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
  PairFixture fixture(surface, {"Enforcement=penalty"}, circle);
  Vector q(fixture.n), before = q;
  before[0] = .01;
  fixture.pair.begin_stage(before, 0.);
  fixture.begin_increment(before, 1., stiffness);
  const auto target = fixture.settle(q);
  BOOST_TEST(fixture.pair.n_touching() == 2u);
  const Tensor1 on_nodes({-target.residual[0] - target.residual[3], -target.residual[1] - target.residual[4]});
  BOOST_TEST((fixture.pair.tool_force() + on_nodes).norm() < 1e-13);
  // The travel's row: the blank pushes back along the direction what the force pushes forward.
  const double pushed_back = -(fixture.pair.tool_force() * fixture.tool.direction());
  BOOST_TEST(std::abs(target.residual[fixture.n - 1] - (pushed_back - 2.)) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
