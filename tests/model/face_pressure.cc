// What presses on a shell is what is found in equilibrium, and fades out with the forces of the tools.
#include "../pressed_strip.h"
#include "model_fixture.h"

#include <boost/test/unit_test.hpp>
#include <deltaform/contact/contact_measures.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// A strip of metal that flows at 1e-3 of Young's modulus: the punch, .02 deep in it, presses far harder.
  struct Fixture : ModelFixture
  {
    explicit Fixture(const std::vector<std::string> &more = {})
      : ModelFixture(entries(more))
    {
      BOOST_TEST_REQUIRE(model.begin_stage(scene.actors.stages.front()).empty());
    }

    static std::vector<std::string> entries(const std::vector<std::string> &more)
    {
      std::vector<std::string> result = pressed_strip(
        {"Blank/Symmetry=plane strain", "Material/Hardening/Law=perfectly plastic",
         "Material/Hardening/Flow stress=10"});
      for (auto &entry : result)
        if (entry == "Material/Model=linear elastic")
          entry = "Material/Model=elastoplastic";
      result.insert(result.end(), more.begin(), more.end());
      return result;
    }

    /// The strip does not move, the punch goes its way.
    void assemble(const double time)
    {
      next.begin(time, 0.);
      BOOST_TEST_REQUIRE(next.assemble(model.committed(), true).good());
    }

    using Points = const std::vector<ContactPointState> &(ContactInterface::*) () const;

    FaceValues pressure(const Points points, const double share = 1.)
    {
      FaceValues result;
      result.fill(std::vector<double>(blank().surface().n_nodes(), 0.));
      for (const auto &interface : scene.actors.interfaces)
        add_contact_pressure(*interface, ((*interface).*points)(), model.committed(), result);
      for (auto &side : result)
        for (auto &value : side)
          value *= share;
      return result;
    }

    Blank &blank()
    {
      return *scene.actors.blank;
    }
  };
} // namespace

BOOST_AUTO_TEST_SUITE(face_pressure)

BOOST_AUTO_TEST_CASE(its_change_is_that_of_the_mean_of_both_faces_over_the_flow_stress)
{
  for (const bool counts : {true, false})
  {
    Fixture fixture({counts ? "Blank/Transverse normal stress=true" : "Blank/Transverse normal stress=false"});
    const unsigned int n_nodes = fixture.blank().surface().n_nodes();
    fixture.blank().set_pressure({{std::vector<double>(n_nodes, 1.), std::vector<double>(n_nodes, 2.)}});
    const double change =
      fixture.blank().pressure_change({{std::vector<double>(n_nodes, 2.), std::vector<double>(n_nodes, 5.)}});
    BOOST_TEST(change == (counts ? .2 : 0.), boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(it_is_corrected_in_equilibrium_and_forgotten_with_the_attempt)
{
  Fixture fixture;
  fixture.assemble(.4);
  const FaceValues trial = fixture.pressure(&ContactInterface::trial);
  BOOST_TEST_REQUIRE(fixture.blank().pressure_change(trial) > 1.);
  BOOST_TEST(fixture.workspace.pressure().correct(fixture.model.committed()));
  BOOST_TEST(fixture.blank().pressure_change(trial) == 0.);
  BOOST_TEST(!fixture.workspace.pressure().correct(fixture.model.committed()));

  fixture.next.begin(.2, 0.);
  BOOST_TEST(fixture.blank().pressure_change(fixture.pressure(&ContactInterface::committed)) == 0.);
}

BOOST_AUTO_TEST_CASE(corrections_that_do_not_settle_come_to_an_end)
{
  Fixture fixture;
  fixture.assemble(.4);
  FacePressure &pressure = fixture.workspace.pressure();
  FaceValues none = fixture.pressure(&ContactInterface::trial, 0.);
  unsigned int n = 0;
  for (; n < 100 && pressure.correct(fixture.model.committed()); ++n)
    fixture.blank().set_pressure(none);
  BOOST_TEST(n == 4u);
}

BOOST_AUTO_TEST_CASE(that_of_a_tool_that_leaves_fades_with_its_force)
{
  Fixture fixture({"Steps/Stages=press, release", "Steps/press/End time=1", "Steps/release/End time=3",
                   "Tools/punch/Stages=press", "Supports/edge/Stages=press, release"});
  fixture.assemble(1.);
  fixture.model.commit(fixture.model.committed(), fixture.workspace);
  const FaceValues whole = fixture.pressure(&ContactInterface::committed),
                   half = fixture.pressure(&ContactInterface::committed, .5);
  BOOST_TEST_REQUIRE(fixture.blank().pressure_change(whole) > 1.);
  fixture.model.begin_stage(fixture.scene.actors.stages.back());
  fixture.next.begin(2., 0.);
  BOOST_TEST(fixture.blank().pressure_change(half) < 1e-12);
  fixture.next.begin(3., 0.);
  BOOST_TEST(fixture.blank().pressure_change(half) > 1.);
}

BOOST_AUTO_TEST_SUITE_END()
