// What a side of the blank meets: tools, and a block on two springs that no scene has.
#include "fake_surface.h"

#include <deltaform/contact/point_rows.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double spring = 40.;

  /// The profile of a tool, carried by two springs: both parts of its way are unknown.
  class Block : public Counterpart
  {
  public:
    explicit Block(const Tool &tool)
      : tool_(tool)
    {
    }

    const Curve &profile() const override
    {
      return tool_.shape();
    }

    Projection project(const Point2 &x, const unsigned int hint) const override
    {
      return tool_.project(x, 0., hint);
    }

    Tensor1 way(const Vector &q, const double /*time*/) const override
    {
      return motion(q);
    }

    unsigned int n_unknowns() const override
    {
      return 2;
    }

    Tensor1 motion(const Vector &d) const override
    {
      return Tensor1({d[first_unknown()], d[first_unknown() + 1]});
    }

    void add_columns(PointRows &rows) const override
    {
      rows.add_column(first_unknown(), Tensor1({1., 0.}));
      rows.add_column(first_unknown() + 1, Tensor1({0., 1.}));
    }

    void add_load(const Vector &q, const double /*time*/, AssemblyTarget &target) const override
    {
      const std::array<DofIndex, 2> dofs{{first_unknown(), first_unknown() + 1}};
      const std::array<double, 4> matrix{{spring, 0., 0., spring}};
      const std::array<double, 2> residual{{spring * q[dofs[0]], spring * q[dofs[1]]}};
      target.add(dofs.data(), 2, target.wants_tangent() ? matrix.data() : nullptr, residual.data());
    }

  private:
    const Tool &tool_;
  };

  const Entries ball = {"Shape=circle", "Radius=1", "Side=bottom", "Position z=-1", "Friction coefficient=.1"};
} // namespace

BOOST_AUTO_TEST_SUITE(counterpart)

BOOST_AUTO_TEST_CASE(a_moved_tool_has_no_unknown)
{
  const FakeSurface surface(1);
  InterfaceFixture fixture(surface, {}, flat + Entries{"Motion=-2*t", "Direction=1 1"});
  const Counterpart &tool = fixture.contact.projector().counterpart();
  const Vector q(fixture.n);
  BOOST_TEST(tool.n_unknowns() == 0u);
  BOOST_TEST((tool.way(q, .5) + Tensor1({1., 1.}) / std::sqrt(2.)).norm() < 1e-15);
  BOOST_TEST(tool.motion(q).norm() == 0.);
}

BOOST_AUTO_TEST_CASE(a_pressed_tool_goes_as_far_as_its_unknown_says)
{
  const FakeSurface surface(1);
  InterfaceFixture fixture(surface, {}, flat + Entries{"Force=3"});
  const Counterpart &tool = fixture.contact.projector().counterpart();
  Vector q(fixture.n);
  q[tool.first_unknown()] = .25;
  BOOST_TEST(tool.n_unknowns() == 1u);
  BOOST_TEST((tool.way(q, 7.) - .25 * fixture.tool.direction()).norm() == 0.);
  BOOST_TEST((tool.motion(q) - tool.way(q, 0.)).norm() == 0.);
  DenseTarget target(fixture.n);
  tool.add_load(q, 7., target);
  BOOST_TEST(target.residual[tool.first_unknown()] == -3.);
}

BOOST_AUTO_TEST_CASE(another_counterpart_takes_its_forces)
{
  FakeSurface surface(3, 0., .05);
  surface.X = {{-.2, .02}, {.05, .04}, {.3, 0.}};
  for (const std::string enforcement : {"penalty", "augmented Lagrangian", "active set"})
    BOOST_TEST_CONTEXT(enforcement)
    {
      InterfaceFixture fixture(surface, {"Enforcement=" + enforcement}, ball,
                               [](const Tool &tool) { return std::make_unique<Block>(tool); });
      const Counterpart &block = fixture.contact.projector().counterpart();
      Vector q(fixture.n);
      for (unsigned int i = 0; i < fixture.n; ++i)
        q[i] = 1e-3 * (i % 4);
      if (fixture.settings.normal_law->has_multiplier())
        for (unsigned int i = 0; i < 3; ++i)
          q[fixture.contact.multiplier_dof(i)] = .5;
      fixture.contact.begin_stage(q, 0.);
      fixture.begin_increment(q, 1., 1e3);
      q[0] += 4e-4;
      q[block.first_unknown()] += 2e-3;
      const auto target = fixture.converge(q);
      BOOST_TEST(fixture.contact.n_touching() == 3u);
      for (const unsigned int k : {0, 1})
      {
        const double on_blank = target.residual[k] + target.residual[2 + k] + target.residual[4 + k];
        const double on_block = target.residual[block.first_unknown() + k] - spring * block.motion(q)[k];
        BOOST_TEST(std::abs(on_blank) > 1e-2);
        BOOST_TEST(std::abs(on_blank + on_block) < 1e-13 * std::abs(on_blank));
      }
      const Assembly assembly = [&](const Vector &state, AssemblyTarget &to) { fixture.contact.assemble(state, to); };
      BOOST_TEST(tangent_error(assembly, q, std::vector<double>(fixture.n, 1.), 1e-6) < 1e-7);
    }
}

BOOST_AUTO_TEST_SUITE_END()
