// Conditions that end a stage: what is understood, when they hold, and that limits are met.
#include <deltaform/conditions/stage_ends.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace deltaform;

namespace
{
  /// An increment of which only the smallest thickness is known.
  class Told : public AcceptedIncrement
  {
  public:
    Told(const Model &the_model, const double the_time, const double thickness)
      : AcceptedIncrement(the_model, the_model.actors().stages.front(), the_time, 1, {})
    {
      smallest_thickness_ = thickness;
    }
  };

  struct Fixture
  {
    Fixture()
      : tree(ParameterTree::parse("", "test",
                                  {"Blank/Points=0 0; 40 0", "Blank/Thickness=2", "Material/Young's modulus=206e3",
                                   "Material/Poisson's ratio=.3", "Material/Model=linear elastic", "Tools/Names=plate",
                                   "Tools/plate/Shape=plate", "Tools/plate/Side=bottom", "Tools/plate/Position z=-1.1",
                                   "Tools/plate/Motion=t"})),
        scene(tree), model(scene.actors, *scene.linear_solver, timers), ends(scene.actors),
        stage(scene.actors.stages.front())
    {
    }

    void enter(const std::string &text)
    {
      stage.ends_when = text;
      ends.enter_stage(stage);
    }

    void refuses(const std::string &text, const std::string &part)
    {
      stage.ends_when = text;
      BOOST_CHECK_EXCEPTION(ends.check(stage), std::invalid_argument, [&](const std::invalid_argument &error) {
        BOOST_TEST_MESSAGE(error.what());
        return std::string(error.what()).find(part) != std::string::npos;
      });
    }

    Timers timers;
    ParameterTree tree;
    Scene scene;
    Model model;
    StageEnds ends;
    Stage stage;
  };
} // namespace

BOOST_FIXTURE_TEST_SUITE(stage_ends, Fixture)

BOOST_AUTO_TEST_CASE(what_is_not_understood)
{
  refuses("plate_forcez > 1", "plate_force_z");
  refuses("thinning = .3", "is not understood");
  refuses("thinning > .3 mm", "is not understood");
  refuses("plate_force_z falls to 1.2", "between 0 and 1");
  stage.ends_when = "thinning > .3; plate_force_z falls to .9; plate_touching < 1; min_thickness < 1.5";
  ends.check(stage);
}

BOOST_AUTO_TEST_CASE(a_limit_is_met)
{
  enter("thinning > .25"); // at a thickness of 1.5
  ends.observe(Told(model, .1, 1.9));
  BOOST_TEST(ends.shorten(.2) == .2); // nothing is known of its rate
  ends.observe(Told(model, .2, 1.8));
  BOOST_TEST(ends.shorten(.3) == .3);
  ends.observe(Told(model, .4, 1.6));
  // It falls by 1 in a unit of time: the limit is met at .5.
  BOOST_TEST(ends.shorten(.6) == .5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(ends.reached().empty());
  ends.observe(Told(model, .5, 1.5001));
  BOOST_TEST(ends.reached().find("thinning > .25") == 0);
}

BOOST_AUTO_TEST_CASE(a_short_increment_does_not_tell_the_rate)
{
  enter("thinning > .25"); // at a thickness of 1.5
  ends.observe(Told(model, .2, 1.8));
  ends.observe(Told(model, .4, 1.6));
  // A tenth of the increment before, in which something else made the sheet thicker.
  ends.observe(Told(model, .42, 1.61));
  // From 1.8 at .2: .19 in .22.
  BOOST_TEST(ends.shorten(.9) == .42 + .11 * .22 / .19, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_share_of_the_largest)
{
  enter("min_thickness falls to .75");
  ends.observe(Told(model, .1, 2.));
  ends.observe(Told(model, .2, 4.));
  ends.observe(Told(model, .3, 3.1));
  BOOST_TEST(ends.reached().empty());
  ends.observe(Told(model, .4, 2.9));
  BOOST_TEST(!ends.reached().empty());
}

BOOST_AUTO_TEST_CASE(contact_lost)
{
  // Nothing touches: fewer than one node do, but not fewer than none.
  enter("plate_touching < 0");
  ends.observe(Told(model, .1, 2.));
  BOOST_TEST(ends.reached().empty());
  stage.name = "next";
  enter("plate_touching < 1");
  ends.observe(Told(model, .1, 2.));
  BOOST_TEST(!ends.reached().empty());
}

BOOST_AUTO_TEST_CASE(what_it_remembers)
{
  enter("min_thickness falls to .75");
  ends.observe(Told(model, .1, 4.));
  const std::string bytes = ends.save();
  StageEnds other(scene.actors);
  other.load(bytes);
  other.enter_stage(stage);
  other.observe(Told(model, .2, 2.9));
  BOOST_TEST(!other.reached().empty());
  // Another stage begins afresh.
  stage.name = "next";
  other.enter_stage(stage);
  BOOST_TEST(other.reached().empty());
  other.observe(Told(model, .3, 2.9));
  BOOST_TEST(other.reached().empty());
}

BOOST_AUTO_TEST_SUITE_END()
