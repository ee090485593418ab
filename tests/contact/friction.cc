// Laws of friction by numbers, and what an interface makes of them.
#include "fake_surface.h"

#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<FrictionLaw> law(const Entries &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return make_friction_law(section);
  }

  FrictionInput point(const double normal_force)
  {
    FrictionInput input;
    input.normal_force = normal_force;
    input.area = 2.;
    input.flow_stress = std::sqrt(3.) * 5.; // k A = 10
    input.stiffness = 100.;
    return input;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(friction)

BOOST_AUTO_TEST_CASE(a_law_without_effect_is_no_object)
{
  BOOST_TEST((law({}) == nullptr));
  BOOST_TEST((law({"Friction coefficient=0"}) == nullptr));
  BOOST_TEST((law({"Friction law=none"}) == nullptr));
  BOOST_TEST((law({"Friction law=shear factor", "Shear factor=0"}) == nullptr));
  BOOST_TEST((law({"Friction law=coulomb with limit", "Friction coefficient=0"}) == nullptr));
  BOOST_TEST((law({"Friction law=coulomb by table", "Coefficient over pressure=0 0; 1 0"}) == nullptr));
  BOOST_TEST((law({"Friction coefficient=.1"}) != nullptr));
}

BOOST_AUTO_TEST_CASE(tables_that_are_none)
{
  const auto refused = [](const std::string &entry, const std::string &reason) {
    const auto with_it = [&]() {
      return law({"Friction law=coulomb by table", "Coefficient over pressure=0 .1", entry});
    };
    BOOST_CHECK_EXCEPTION(with_it(), SceneError, [&](const SceneError &error) {
      return std::string(error.what()).find(reason) != std::string::npos;
    });
  };
  refused("Coefficient over pressure=1 .1; 2 .1", "must begin with 0");
  refused("Coefficient over pressure=0 .1; 2 .1; 1 .1", "must increase");
  refused("Coefficient over pressure=0 .1; 2 -.1", "negative");
  refused("Coefficient over pressure=0 .2; 10 .05", "the friction force falls");
  refused("Factor over slip=0 1; 0 2", "must increase");
}

BOOST_AUTO_TEST_CASE(limits_by_hand)
{
  const auto shear = law({"Friction law=shear factor", "Shear factor=.3"});
  for (const double lambda : {0., 1., 1e3})
  {
    BOOST_TEST(std::abs(shear->limit(point(lambda)).value - std::min(3., lambda)) < 1e-14);
    BOOST_TEST(shear->limit(point(lambda)).rate == (lambda > 3. ? 0. : 1.));
  }
  const auto both =
    law({"Friction law=coulomb with limit", "Friction coefficient=.1", "Shear factor=.4"}); // equal at lambda = 40
  BOOST_TEST(std::abs(both->limit(point(39.)).value - 3.9) < 1e-14);
  BOOST_TEST(both->limit(point(39.)).rate == .1);
  BOOST_TEST(std::abs(both->limit(point(41.)).value - 4.) < 1e-14);
  BOOST_TEST(both->limit(point(41.)).rate == 0.);
  // mu falls from .2 to .1 at the pressure 10, that is lambda = 20, and doubles over a path of 4.
  const auto table = law({"Friction law=coulomb by table", "Coefficient over pressure=0 .2; 10 .1",
                          "Factor over slip=0 1; 4 2"});
  BOOST_TEST(std::abs(table->limit(point(10.)).value - 1.5) < 1e-14);
  BOOST_TEST(std::abs(table->limit(point(10.)).rate - .1) < 1e-14);
  BOOST_TEST(std::abs(table->limit(point(60.)).value - 6.) < 1e-14);
  BOOST_TEST(std::abs(table->limit(point(60.)).rate - .1) < 1e-14);
  FrictionInput slid = point(10.);
  slid.slip = 1.;
  BOOST_TEST(std::abs(table->limit(slid).value - 1.875) < 1e-14);
  slid.slip = 9.;
  BOOST_TEST(std::abs(table->limit(slid).value - 3.) < 1e-14);
  // An elastic surface carries everything.
  FrictionInput elastic = point(41.);
  elastic.flow_stress = std::numeric_limits<double>::infinity();
  BOOST_TEST(std::abs(both->limit(elastic).value - 4.1) < 1e-14);

  FrictionInput moved = point(10.);
  moved.slip_increment = -.029;
  BOOST_TEST(std::abs(shear->update(moved).force + 2.9) < 1e-14);
  BOOST_TEST(shear->update(moved).sticking);
  moved.slip_increment = -.5;
  BOOST_TEST(std::abs(shear->update(moved).force + 3.) < 1e-14);
  BOOST_TEST(!shear->update(moved).sticking);
}

BOOST_AUTO_TEST_CASE(only_what_can_be_wrong_is_doubted)
{
  BOOST_TEST(law({"Friction coefficient=1"})->doubt().empty());
  BOOST_TEST(law({"Friction coefficient=1.01"})->doubt().find("Friction coefficient = 1.01") == 0u);
}

BOOST_AUTO_TEST_CASE(the_flow_stress_of_the_surface_bounds_the_force)
{
  // Three nodes are pressed on a plate and dragged along: m k A each, but no more than the force that presses them; the
  // axis nothing.
  for (const double depth : {.01, .05, .2, 1.})
  {
    FakeSurface surface(4);
    for (unsigned int i = 0; i < 4; ++i)
      surface.X[i] = Point2(.5 * i, 0.);
    surface.area = .4;
    surface.yield = 7.;
    surface.axis_node = 0;
    InterfaceFixture fixture(
      surface, {"Enforcement=penalty"}, flat + Entries{"Friction law=shear factor", "Shear factor=.6"});
    Vector before(fixture.n), q(fixture.n);
    for (unsigned int i = 0; i < 4; ++i)
    {
      q[2 * i] = 2.; // far enough to slide
      q[2 * i + 1] = -depth;
    }
    fixture.contact.begin_stage(before, 0.);
    fixture.begin_increment(before, 1., 1e3);
    fixture.converge(q);
    BOOST_TEST(fixture.contact.n_touching() == 3u);
    const double each = std::min(.6 * 7. / std::sqrt(3.) * .4, 10. * depth); // which is its penalty factor
    BOOST_TEST(std::abs(std::abs(fixture.contact.tool_force()[0]) - 3. * each) < 1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()
