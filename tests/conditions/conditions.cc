// What ends a run, or makes its result doubtful.
#include "../solver/mpi.h"

#include <deltaform/conditions/conditions.h>
#include <deltaform/conditions/worst_imbalance.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  /// An increment that was not computed: only what is said of it matters.
  class Told : public AcceptedIncrement
  {
  public:
    explicit Told(const Model &the_model)
      : AcceptedIncrement(the_model, the_model.actors().stages.front(), 1., 1, {})
    {
      energies_ = EnergyAccount();
      contact_ = ContactAccount();
      balance_error_ = 0.;
      smallest_thickness_ = 3.;
      sections_.emplace();
      sharpest_bend_.emplace();
      largest_shear_.emplace();
      folded_cells_.emplace();
      overlap_.emplace();
      innermost_place_.emplace();
      mesh_error_.emplace();
    }

    EnergyAccount &account()
    {
      return *energies_;
    }

    using AcceptedIncrement::balance_error_;
    using AcceptedIncrement::contact_;
    using AcceptedIncrement::folded_cells_;
    using AcceptedIncrement::innermost_place_;
    using AcceptedIncrement::largest_shear_;
    using AcceptedIncrement::mesh_error_;
    using AcceptedIncrement::overlap_;
    using AcceptedIncrement::sections_;
    using AcceptedIncrement::sharpest_bend_;
    using AcceptedIncrement::smallest_thickness_;
  };

  /// A disc on a plate.
  struct Fixture
  {
    Fixture()
      : tree(ParameterTree::parse("", "test",
                                  {"Blank/Points=0 0; 40 0", "Blank/Thickness=3", "Material/Young's modulus=206e3",
                                   "Material/Poisson's ratio=.3", "Material/Model=linear elastic", "Tools/Names=plate",
                                   "Tools/plate/Shape=plate", "Tools/plate/Side=bottom", "Tools/plate/Position z=-1.6",
                                   "Tools/plate/Motion=t"})),
        scene(tree), model(scene.actors, *scene.linear_solver, timers), increment(model),
        conditions(scene.actors)
    {
    }

    void observe()
    {
      conditions.observe(increment);
    }

    std::vector<std::string> said(const bool done = false) const
    {
      return conditions.warnings(done);
    }

    /// Warnings after the increment.
    std::vector<std::string> warnings(const bool done = false)
    {
      observe();
      return said(done);
    }

    Timers timers;
    ParameterTree tree;
    Scene scene;
    Model model;
    Told increment;
    Conditions conditions;
  };

  bool one_has(const std::vector<std::string> &texts, const std::string &part)
  {
    return texts.size() == 1 && texts.front().find(part) != std::string::npos;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(conditions)

BOOST_AUTO_TEST_CASE(a_sound_increment_says_nothing)
{
  Fixture fixture;
  fixture.increment.account().tool_work = 1.0099;
  fixture.increment.account().elastic = 1.;
  fixture.increment.balance_error_ = 9e-4;
  fixture.increment.smallest_thickness_ = 1.01;
  BOOST_TEST(fixture.warnings().empty());
  BOOST_TEST(fixture.conditions.failure(fixture.scene.actors.stages.front()).empty());
  BOOST_TEST(fixture.conditions.likely_cause().empty());
}

BOOST_AUTO_TEST_CASE(a_refused_increment_that_would_neck_has_that_as_its_likely_cause)
{
  // In tension, without hardening; node 1 would stretch by .5 and thin as much.
  Fixture fixture;
  SheetSection section;
  section.thickness = 3.;
  section.stress = 200.;
  const std::vector<SheetSection> now(3, section);
  fixture.increment.sections_ = now;
  fixture.observe();
  std::vector<SheetSection> refused = now;
  refused[1].stretch = refused[1].thinning = .5;
  refused[1].thickness = 3. * std::exp(-.5);
  BOOST_TEST(fixture.conditions.likely_cause(refused).find("necks at once: its thickness falls from 3 to 1.82") !=
             std::string::npos);
  BOOST_TEST(fixture.conditions.likely_cause(now).empty());
  BOOST_TEST(fixture.conditions.likely_cause().empty());
  BOOST_TEST(fixture.warnings().empty());
}

BOOST_AUTO_TEST_CASE(an_element_that_bends_too_much_is_told)
{
  Fixture fixture;
  fixture.increment.sharpest_bend_ = SharpestBend{.26, 7.};
  BOOST_TEST(fixture.warnings().empty());
  fixture.increment.sharpest_bend_ = SharpestBend{.27, 7.};
  BOOST_TEST(one_has(fixture.warnings(), "the element at R0 = 7 bends by 15.47 degrees, at time 1"));
  fixture.increment.sharpest_bend_ = SharpestBend{.1, 8.};
  BOOST_TEST(one_has(fixture.warnings(), "R0 = 7"));
  // By more than a radian it is no result.
  const auto ends = [&]() { return fixture.conditions.failure(fixture.scene.actors.stages.front()); };
  fixture.increment.sharpest_bend_ = SharpestBend{1.04, 7., 2.};
  fixture.observe();
  BOOST_TEST(ends().empty());
  fixture.increment.sharpest_bend_ = SharpestBend{1.05, 9.};
  fixture.observe();
  BOOST_TEST(ends().find("the element at R0 = 9 bends by 60.16 degrees") == 0u, ends());
  BOOST_TEST(fixture.warnings().empty()); // it is said once
}

BOOST_AUTO_TEST_CASE(a_sheet_that_flows_by_shear_is_told)
{
  // Nine tenths of the work and more without much of it: no word.
  Fixture fixture;
  const auto work_to = [&](const double work, const double share) {
    fixture.increment.account().tool_work = fixture.increment.account().elastic = work;
    fixture.increment.largest_shear_ = LargestShear{share, 7.};
    fixture.increment.time += 1.;
    return fixture.warnings();
  };
  BOOST_TEST(work_to(2., .9).size() == 1u); // all of it so far
  BOOST_TEST(work_to(10., .349).size() == 1u);
  BOOST_TEST(work_to(21., .3).empty());
  // A tool that goes back takes work out, and that counts as well.
  BOOST_TEST(one_has(work_to(20., .36), "sheared shell: at time 2 the sheet carries a transverse shear of 0.9 of its "
                                        "flow stress, at R0 = 7, and more than 0.35 in 14 % of the work"));

  // No work is known: one look of two.
  Fixture without;
  without.increment.largest_shear_ = LargestShear{.3, 7.};
  BOOST_TEST(without.warnings().empty());
  without.increment.time += 1.;
  without.increment.largest_shear_ = LargestShear{.9, 7.};
  BOOST_TEST(one_has(without.warnings(), "and more than 0.35 in 50 % of the time. It flows"));
}

BOOST_AUTO_TEST_CASE(a_corner_that_is_too_sharp_is_told)
{
  Fixture fixture;
  fixture.increment.sharpest_bend_ = SharpestBend{1.05, 9., .4};
  fixture.observe();
  const std::string said = fixture.conditions.failure(fixture.scene.actors.stages.front());
  BOOST_TEST(said.find("the sheet bends by 60.16 degrees within 0.4 of its thickness at R0 = 9, at time 1. The corner "
                       "there is too sharp for a shell") == 0u,
             said);
  BOOST_TEST(said.find("Give the tool a larger radius") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_mesh_that_folds_over_is_told_and_then_ends_the_run)
{
  Fixture fixture;
  const auto ends = [&]() { return fixture.conditions.failure(fixture.scene.actors.stages.front()); };
  fixture.increment.folded_cells_ = FoldedCells{.009, Point2(7., 3.)};
  BOOST_TEST(fixture.warnings().empty());
  fixture.increment.folded_cells_ = FoldedCells{.02, Point2(7., 3.)};
  BOOST_TEST(one_has(fixture.warnings(), "in 2 % of the section, at time 1, cells are turned inside out"));
  BOOST_TEST(fixture.conditions.likely_cause().find("R0 = 7, Z0 = 3") != std::string::npos);
  BOOST_TEST(ends().empty());
  fixture.increment.folded_cells_ = FoldedCells{.11, Point2(8., 3.)};
  fixture.observe();
  BOOST_TEST(ends().find("the mesh has folded over: in 11 % of the section") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_sheet_within_itself_ends_the_run)
{
  Fixture fixture;
  const auto ends = [&]() { return fixture.conditions.failure(fixture.scene.actors.stages.front()); };
  fixture.increment.overlap_ = Overlap{.09, 7., 9.};
  fixture.observe();
  BOOST_TEST(ends().empty());
  fixture.increment.overlap_ = Overlap{.11, 7., 9.};
  fixture.observe();
  BOOST_TEST(ends().find("its parts at R0 = 7 and 9 overlap by 11 % of the thickness") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(energies_count_at_the_end_only)
{
  Fixture fixture;
  fixture.increment.account().tool_work = 1.;
  fixture.increment.account().elastic = .5;
  BOOST_TEST(one_has(fixture.warnings(), "works and energies differ by 50 %"));
  fixture.increment.account().elastic = .9901;
  BOOST_TEST(fixture.warnings().empty());
}

BOOST_AUTO_TEST_CASE(work_of_friction_counts_where_it_matters)
{
  Fixture fixture;
  EnergyAccount &account = fixture.increment.account();
  account.tool_work = 1.;
  account.plastic = .98;
  account.friction = .02;
  account.friction_error = .0019;
  BOOST_TEST(one_has(fixture.warnings(), "friction work: it is uncertain by about 9.5 %"));
  account.friction = .005;
  account.plastic = .995;
  BOOST_TEST(fixture.warnings().empty());
}

BOOST_AUTO_TEST_CASE(what_contact_at_points_takes_of_the_work)
{
  Fixture fixture;
  EnergyAccount &account = fixture.increment.account();
  account.tool_work = account.elastic = 1.;
  account.climbing = .0199;
  BOOST_TEST(fixture.warnings().empty());
  account.climbing = .031;
  BOOST_TEST(one_has(fixture.warnings(), "stand apart on a radius, which takes 3.1 % of the work"));
  account.climbing = -.031;
  BOOST_TEST(one_has(fixture.warnings(), "which adds 3.1 % of the work"));
  // Ten points lie inside the elements of the shell: others slide more freely.
  BOOST_TEST(one_has(fixture.said(), "(Blank/Elements, Grading), or Blank/Contact points = moving."));
}

BOOST_AUTO_TEST_CASE(forces_count_in_every_increment)
{
  Fixture fixture;
  fixture.increment.balance_error_ = 2e-3;
  BOOST_TEST(one_has(fixture.warnings(), "leave 0.2 % of the largest of them unbalanced at time 1"));
  fixture.increment.balance_error_ = 0.;
  fixture.increment.time = 2.;
  BOOST_TEST(one_has(fixture.warnings(), "at time 1"));
}

BOOST_AUTO_TEST_CASE(forces_are_judged_by_those_of_the_run)
{
  WorstImbalance imbalance;
  BOOST_TEST(imbalance.worst() == nullptr);
  // All of .03 N, where the run goes on to 37 kN: a tool alone at a blank that hangs free.
  imbalance.tell(1., .03, .25);
  BOOST_TEST_REQUIRE(imbalance.worst() != nullptr); // so far it is all there is
  BOOST_TEST(imbalance.worst()->time == .25);
  imbalance.tell(1e-9, 37e3, 46.);
  BOOST_TEST(imbalance.worst() == nullptr);
  // A hundredth of 7 N counts, 2e-6 of what comes later.
  imbalance.tell(1.3e-2, 7., 47.);
  BOOST_TEST_REQUIRE(imbalance.worst() != nullptr);
  BOOST_TEST(imbalance.worst()->time == 47.);
  // Half of 10 N is more: the curve of the force begins wrong.
  imbalance.tell(.5, 10., 50.);
  BOOST_TEST_REQUIRE(imbalance.worst() != nullptr);
  BOOST_TEST(imbalance.worst()->time == 50.);
  // The largest error counts, and one of a thousandth does not.
  imbalance.tell(.2, 37e3, 51.);
  imbalance.tell(.9, 37e3, 52.);
  imbalance.tell(9e-4, 37e3, 53.);
  BOOST_TEST(imbalance.worst()->time == 52.);
}

BOOST_AUTO_TEST_CASE(a_face_that_is_deep_in_a_tool_between_its_points)
{
  Fixture fixture;
  auto &deepest = fixture.increment.contact_->deepest;
  deepest = {49., .149, Point2(12., 1.), 0};
  BOOST_TEST(fixture.warnings().empty());
  deepest = {120., .36, Point2(12., 1.), 0};
  BOOST_TEST(one_has(fixture.warnings(),
                     "the blank is 0.36 deep in tool 'plate', 12 % of the thickness and 120 times delta, "
                     "at r = 12, z = 1, time 1"));
  // The worst stays, with its time.
  deepest = {100., .31, Point2(13., 1.), 0};
  fixture.increment.time = 2.;
  BOOST_TEST(one_has(fixture.warnings(), "at r = 12, z = 1, time 1"));
}

BOOST_AUTO_TEST_CASE(a_third_of_the_thickness)
{
  Fixture fixture;
  fixture.increment.smallest_thickness_ = .99;
  BOOST_TEST(one_has(fixture.warnings(), "33 % of what it was"));
}

BOOST_AUTO_TEST_CASE(a_tool_that_never_touched)
{
  Fixture fixture;
  BOOST_TEST(one_has(fixture.warnings(true), "tool 'plate' has never touched"));
  // A run that stopped may have stopped before.
  BOOST_TEST(fixture.said(false).empty());
}

BOOST_AUTO_TEST_CASE(snaps_are_counted)
{
  Fixture fixture;
  for (const double rotation : {.4, .5, .45})
  {
    fixture.increment.snap.rotation = rotation;
    fixture.observe();
    fixture.increment.time += 1.;
  }
  const auto said = fixture.said();
  BOOST_TEST(one_has(said, "in 3 increments"));
  BOOST_TEST(one_has(said, "by up to 0.5 rad at once (the most at time 2)"));
}

BOOST_AUTO_TEST_CASE(strain_of_a_snap_is_said)
{
  Fixture fixture;
  fixture.increment.snap.strain = .2;
  BOOST_TEST(one_has(fixture.warnings(), "strain of a snap: in 1 increments"));
  BOOST_TEST(one_has(fixture.said(), "points strained by up to 0.2 at once (the most at time 1)"));
}

BOOST_AUTO_TEST_CASE(strain_of_a_refinement_is_said)
{
  Fixture fixture;
  fixture.increment.strain_at_rest = .3;
  BOOST_TEST(one_has(fixture.warnings(), "after 1 refinements strained a point by up to 0.3"));
}

BOOST_AUTO_TEST_CASE(a_mesh_that_does_not_resolve_the_flow_is_told)
{
  Fixture fixture;
  fixture.increment.time = .1;
  fixture.increment.mesh_error_ = MeshError{1., .029};
  BOOST_TEST(fixture.warnings().empty());
  // It counts by its work.
  fixture.increment.time = .2;
  fixture.increment.mesh_error_ = MeshError{1., .035};
  BOOST_TEST(one_has(fixture.warnings(), "by 3.2 % of the plastic work"));
  // What follows within a fiftieth of the stage is not looked at.
  fixture.increment.time = .21;
  fixture.increment.mesh_error_ = MeshError{1e3, 0.};
  BOOST_TEST(fixture.warnings().size() == 1u);
  fixture.increment.time = .22;
  BOOST_TEST(fixture.warnings().empty());
}

BOOST_AUTO_TEST_CASE(an_ironed_shell_ends_the_run_after_two_increments)
{
  Fixture fixture;
  SheetSection section{};
  section.flow_stress = 200.;
  section.clamping_pressure = 250.;
  fixture.increment.sections_ = std::vector<SheetSection>{section};
  const auto failures = [&]() {
    return fixture.conditions.failure(fixture.increment.stage);
  };
  fixture.observe();
  BOOST_TEST(failures().empty());
  fixture.observe();
  BOOST_TEST(failures().find("iron the sheet") != std::string::npos);
  BOOST_TEST(failures().find("Blank/Kind = solid") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_blank_beyond_its_line_of_symmetry_ends_the_run)
{
  Fixture fixture;
  const auto failure_at = [&](const double r) {
    fixture.increment.innermost_place_ = InnermostPlace{r, 17, 25.};
    fixture.observe();
    ++fixture.increment.number;
    return fixture.conditions.failure(fixture.increment.stage);
  };
  BOOST_TEST(failure_at(2.).empty());
  BOOST_TEST(failure_at(-.2).empty()); // a tenth of the thickness is .3
  const std::string failure = failure_at(-.4);
  BOOST_TEST(failure.find("node 17 (R0 = 25) lies 0.4 beyond it after increment 3") != std::string::npos, failure);
}

BOOST_AUTO_TEST_CASE(a_name_is_taken_once)
{
  const auto again = [](const Actors &) { return std::unique_ptr<Condition>(); };
  BOOST_CHECK_THROW(ConditionMakers::Entry("snaps", "again", again), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
