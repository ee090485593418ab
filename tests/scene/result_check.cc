#include <deltaform/base/command_line.h>
#include <deltaform/base/parameter_tree.h>
#include <deltaform/scene/result_check.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  /// A disc on a plate, which is not computed: only what is said of its rows matters.
  struct Fixture
  {
    Fixture()
      : tree(ParameterTree::parse("",
                                  "test",
                                  {"Blank/Points=0 0; 40 0",
                                   "Blank/Thickness=3",
                                   "Material/Young's modulus=206e3",
                                   "Material/Poisson's ratio=.3",
                                   "Material/Model=linear elastic",
                                   "Tools/Names=plate",
                                   "Tools/plate/Shape=plate",
                                   "Tools/plate/Side=bottom",
                                   "Tools/plate/Position z=-1.6",
                                   "Tools/plate/Motion=t"})),
        scene(tree), check(scene.actors)
    {
      row.min_thickness = 3.;
      row.time = 1.;
    }

    /// Warnings after the increment of @ref row.
    std::vector<std::string> warnings(const int exit_status = exit_status::not_converged)
    {
      check.observe(scene.actors.stages.front(), row);
      return check.warnings(exit_status);
    }

    ParameterTree tree;
    Scene scene;
    ResultCheck check;
    HistoryRow row;
  };

  bool one_has(const std::vector<std::string> &texts, const std::string &part)
  {
    return texts.size() == 1 && texts.front().find(part) != std::string::npos;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(result_check)

BOOST_AUTO_TEST_CASE(a_sound_row_says_nothing)
{
  Fixture fixture;
  fixture.row.energy_error = -.0199;
  fixture.row.balance_error = 9e-4;
  fixture.row.min_thickness = 1.01;
  BOOST_TEST(fixture.warnings().empty());
  BOOST_TEST(fixture.check.failure(fixture.scene.actors.stages.front()).empty());
}

BOOST_AUTO_TEST_CASE(energies_count_at_the_end_only)
{
  Fixture fixture;
  fixture.row.energy_error = -.5;
  BOOST_TEST(one_has(fixture.warnings(), "works and energies differ by 50 %"));
  fixture.row.energy_error = .01;
  BOOST_TEST(fixture.warnings().empty());
}

BOOST_AUTO_TEST_CASE(forces_count_in_every_row)
{
  Fixture fixture;
  fixture.row.balance_error = 2e-3;
  BOOST_TEST(one_has(fixture.warnings(), "leave 0.2 % of the largest of them unbalanced at time 1"));
  fixture.row.balance_error = 0.;
  fixture.row.time = 2.;
  BOOST_TEST(one_has(fixture.warnings(), "at time 1"));
}

BOOST_AUTO_TEST_CASE(a_third_of_the_thickness)
{
  Fixture fixture;
  fixture.row.min_thickness = .99;
  BOOST_TEST(one_has(fixture.warnings(), "33 % of what it was"));
}

BOOST_AUTO_TEST_CASE(a_tool_that_never_touched)
{
  Fixture fixture;
  BOOST_TEST(one_has(fixture.warnings(exit_status::done), "tool 'plate' has never touched"));
  // A run that stopped may have stopped before.
  BOOST_TEST(fixture.check.warnings(exit_status::not_converged).empty());
}

BOOST_AUTO_TEST_CASE(snaps_are_counted)
{
  Fixture fixture;
  fixture.check.snapped(fixture.row, .4);
  fixture.row.time = 2.;
  fixture.check.snapped(fixture.row, .5);
  fixture.row.time = 3.;
  fixture.check.snapped(fixture.row, .45);
  const auto said = fixture.check.warnings(exit_status::not_converged);
  BOOST_TEST(one_has(said, "in 3 increments"));
  BOOST_TEST(one_has(said, "by up to 0.5 rad (the most at time 2)"));
}

BOOST_AUTO_TEST_SUITE_END()
