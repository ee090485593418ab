// An increment and its strategies, on a problem of two unknowns: an arch with a limit point, and a node that is moved.
#include "arch.h"

#include <deltaform/process/child_process.h>
#include <deltaform/process/interruption.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <csignal>
#include <limits>

using namespace deltaform;
using namespace deltaform::testing;

BOOST_AUTO_TEST_SUITE(increment)

BOOST_AUTO_TEST_CASE(the_plain_strategy_is_enough_for_most)
{
  ArchFixture fixture;
  const auto result = fixture.to(.1, Effort::all);
  BOOST_TEST(!result.rejected);
  const double u = result.q[0];
  BOOST_TEST(std::abs(u * (u - 1.) * (u - 2.) - .1) < 1e-6);
  BOOST_TEST(fixture.problem.n_begun == 1u);
  BOOST_TEST(result.snap.rotation == 0.);
  BOOST_TEST(result.cost.iterations == result.iterations_to_equilibrium);
  // What was found is the caller's to accept.
  BOOST_TEST(fixture.problem.q[0] == 0.);
}

BOOST_AUTO_TEST_CASE(a_ladder_is_a_list_of_names)
{
  BOOST_TEST(usual_ladder().size() == 4u);
  BOOST_CHECK_THROW(make_ladder({"plain", "wishful thinking"}), std::out_of_range);
  // Nothing can touch: the only strategy is none for this problem.
  ArchFixture fixture;
  Increment soft(fixture.problem, fixture.newton, fixture.steps, make_ladder({"soft contact"}));
  const auto result = soft.attempt({.1, .1, true, fixture.predictor}, Effort::usual);
  BOOST_REQUIRE(result.rejected.has_value());
  BOOST_TEST((result.rejected->kind == Rejected::Kind::not_solved));
  BOOST_TEST(result.rejected->sentence == "no strategy applies to this increment");
}

BOOST_AUTO_TEST_CASE(strategies_wait_for_their_effort)
{
  const auto effort = [](const char *name) { return make_ladder({name}).front()->least_effort(); };
  BOOST_TEST((effort("plain") == Effort::first));
  BOOST_TEST((effort("soft contact") == Effort::usual));
  BOOST_TEST((make_ladder({"soft contact"}).front()->most_effort() == Effort::usual));
  BOOST_TEST((effort("viscous") == Effort::last_resorts));
  BOOST_TEST((effort("viscous, a long way") == Effort::all));
  // The first attempt is Newton's method alone.
  ArchFixture fixture;
  Increment both(fixture.problem, fixture.newton, fixture.steps, make_ladder({"viscous", "plain"}));
  BOOST_TEST(!both.attempt({.1, .1, true, fixture.predictor}, Effort::first).rejected.has_value());
  BOOST_TEST(fixture.problem.n_begun == 1u);
}

BOOST_AUTO_TEST_CASE(it_starts_from_the_last_velocity)
{
  ArchFixture fixture;
  fixture.problem.q[0] = .05;
  Vector before(2);
  before[0] = .03;
  fixture.predictor.accept(before, fixture.problem.q, .24, fixture.problem.system);
  fixture.to(.12, Effort::usual);
  BOOST_TEST(fixture.problem.visited.front() == .06, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(stiff_contact_is_softened)
{
  ArchFixture fixture;
  fixture.problem.touches = true;
  const auto result = fixture.to(.1, Effort::usual);
  BOOST_TEST(!result.rejected);
  BOOST_TEST(fixture.problem.n_begun == 2u);
  BOOST_TEST(fixture.problem.is_soft);
  // The iterations of the attempt that failed count.
  BOOST_TEST(result.cost.iterations > 3u);
}

BOOST_AUTO_TEST_CASE(contact_is_not_softened_among_the_last_resorts)
{
  ArchFixture fixture;
  fixture.problem.touches = true;
  fixture.to(.1, Effort::last_resorts);
  BOOST_TEST(!fixture.problem.is_soft);
}

BOOST_AUTO_TEST_CASE(a_snap_needs_the_last_resorts)
{
  ArchFixture fixture({"Largest strain increment=1"});
  fixture.problem.q[0] = .4;
  const auto usual = fixture.to(.4049, Effort::usual);
  BOOST_REQUIRE(usual.rejected.has_value());
  BOOST_TEST((usual.rejected->kind == Rejected::Kind::not_solved));
  BOOST_TEST(usual.rejected->sentence.find("crown") != std::string::npos);

  const auto far = fixture.to(.4049, Effort::last_resorts);
  BOOST_REQUIRE(far.rejected.has_value());
  BOOST_TEST((far.rejected->kind == Rejected::Kind::too_large), far.rejected->sentence);
  BOOST_TEST(far.rejected->sentence.find("at R0 = 0.75, Z0 = 1; allowed are") != std::string::npos);
  BOOST_TEST(far.rejected->sentence.find("Largest rotation increment") != std::string::npos);
  BOOST_TEST(far.cost.iterations > usual.cost.iterations); // both strategies

  const auto all = fixture.to(.4049, Effort::all);
  BOOST_TEST(!all.rejected);
  BOOST_TEST(all.q[0] > 2.);
  BOOST_TEST(all.snap.rotation == all.q[0] - .4, boost::test_tools::tolerance(1e-12));

  BOOST_TEST(all.snap.strain == 0.);

  // It may strain a point by more, too, but not by much more.
  fixture.problem.strain = 2.9;
  BOOST_TEST(fixture.to(.4049, Effort::last_resorts).rejected.has_value());
  const auto further = fixture.to(.4049, Effort::all);
  BOOST_TEST(!further.rejected);
  BOOST_TEST(further.snap.strain == 2.9);
  BOOST_TEST(further.size == 0.);
  fixture.problem.strain = 3.1;
  const auto strained = fixture.to(.4049, Effort::all);
  BOOST_REQUIRE(strained.rejected.has_value());
  BOOST_TEST(strained.rejected->sentence ==
             "the largest strain increment is 3.1, at R0 = 0.25, Z0 = -0.5; allowed are 1 (Solver/Largest strain "
             "increment)");
}

BOOST_AUTO_TEST_CASE(a_last_resort_snaps_from_half_of_the_limits_on)
{
  for (const auto &[limit, is_snap] : {std::pair("2", true), {"3", true}, {"5", false}})
  {
    ArchFixture fixture({"Largest strain increment=1", std::string("Largest rotation increment=") + limit});
    fixture.problem.q[0] = .4;
    const auto result = fixture.to(.4049, Effort::last_resorts);
    BOOST_TEST_REQUIRE(!result.rejected, limit);
    BOOST_TEST(result.snap.rotation == (is_snap ? result.q[0] - .4 : 0.), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(result.size > 0.);
  }
}

BOOST_AUTO_TEST_CASE(a_signal_ends_the_ladder)
{
  // As in the case before, but that no other strategy is tried after a signal has come.
  const auto n_tried = [](const bool signal) {
    start_process(
      [signal]() {
        interruption::watch();
        if (signal)
          std::raise(SIGTERM);
        ArchFixture fixture({"Largest strain increment=1"});
        fixture.problem.q[0] = .4;
        fixture.to(.4049, Effort::all);
        return static_cast<int>(fixture.problem.n_begun);
      },
      "/dev/null");
    return wait_for_process(std::numeric_limits<double>::infinity())->exit_status;
  };
  BOOST_TEST(n_tried(true) == 1);
  BOOST_TEST(n_tried(false) > 1);
}

BOOST_AUTO_TEST_CASE(at_the_same_time_any_rotation_will_do_and_a_large_strain_is_said)
{
  ArchFixture fixture({"Largest rotation increment=1e-3"});
  fixture.problem.q[0] = .3;
  const IncrementStart start{.1, 0., true, fixture.predictor};
  const auto result = fixture.increment.attempt(start, Effort::usual);
  BOOST_TEST(!result.rejected);
  BOOST_TEST(result.strain_at_rest == 0.);
  // So will any strain, but it is remembered.
  fixture.problem.strain = .7;
  const auto far = fixture.increment.attempt(start, Effort::last_resorts);
  BOOST_TEST(!far.rejected);
  BOOST_TEST(far.strain_at_rest == .7);
}

BOOST_AUTO_TEST_CASE(a_broken_promise_is_no_solution)
{
  ArchFixture fixture;
  fixture.problem.broken = "the promise is broken at the crown";
  const auto result = fixture.to(.1, Effort::all);
  BOOST_REQUIRE(result.rejected.has_value());
  BOOST_TEST((result.rejected->kind == Rejected::Kind::promise_broken));
  BOOST_TEST(result.rejected->sentence == fixture.problem.broken);
  BOOST_TEST(fixture.problem.n_begun == 1u); // no other strategy helps
}

BOOST_AUTO_TEST_CASE(corrections_are_counted_apart)
{
  ArchFixture fixture;
  fixture.problem.n_corrections = 2;
  const auto result = fixture.to(.1, Effort::usual);
  BOOST_TEST(!result.rejected);
  BOOST_TEST(result.cost.rounds == 2u);
  BOOST_TEST(result.iterations_to_equilibrium == result.cost.iterations - result.cost.correction_iterations);

  fixture.problem.n_corrections = 1000;
  const auto endless = fixture.to(.1, Effort::all);
  BOOST_REQUIRE(endless.rejected.has_value());
  BOOST_TEST(endless.rejected->sentence.find("corrections") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
