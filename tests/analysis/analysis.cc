// An analysis as a program uses it that is not ours: one increment at a time, no files.
#include "../pressed_strip.h"
#include "../solver/mpi.h"

#include <deltaform/analysis/analysis.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  struct Run
  {
    Run()
      : tree(ParameterTree::parse("", "test", pressed_strip())), scene(tree),
        journal(Journal::Console::silent, said, said),
        analysis(scene.actors, scene.analysis_settings(), journal, timers)
    {
    }

    std::ostringstream said;
    Timers timers;
    ParameterTree tree;
    Scene scene;
    Journal journal;
    Analysis analysis;
  };

  /// Counts what it is told.
  struct Counter : public Observer
  {
    explicit Counter(std::string &the_log)
      : log(the_log)
    {
    }

    void begin(const Model &, const Stage &) override
    {
      log += "begin ";
    }
    void before(const Model &, unsigned int) override
    {
      log += "before ";
    }
    void solved(const Model &, const System &, const Vector &) override
    {
      log += "solved ";
    }
    void accepted(const AcceptedIncrement &increment) override
    {
      log += std::to_string(increment.number) + (increment.ends_stage ? " end " : " ");
    }
    void moved(const AcceptedIncrement &increment) override
    {
      log += "moved to " + std::to_string(increment.number) + " ";
    }
    void ended(const Model &, const RunOutcome &outcome) override
    {
      log += "status " + std::to_string(outcome.exit_status);
    }

    std::string &log;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(analysis)

BOOST_AUTO_TEST_CASE(step_by_step_is_the_whole_run)
{
  Run whole, steps;
  BOOST_TEST(whole.analysis.run() == exit_status::done);
  steps.analysis.begin();
  unsigned int n = 0;
  double last = 0.;
  while (steps.analysis.advance())
  {
    ++n;
    BOOST_TEST(steps.analysis.time() > last);
    last = steps.analysis.time();
  }
  BOOST_TEST(steps.analysis.end() == exit_status::done);
  BOOST_TEST(n >= 10u);
  BOOST_TEST(last == 1.);
  BOOST_TEST(steps.analysis.message().empty());
  BOOST_TEST(whole.analysis.model().tool_forces()[0][1] == steps.analysis.model().tool_forces()[0][1]);
  BOOST_TEST(whole.analysis.model().tool_forces()[0][1] > 0.);
}

BOOST_AUTO_TEST_CASE(a_saved_state_goes_on_in_another_analysis)
{
  Run whole, first, second;
  whole.analysis.run();
  first.analysis.begin();
  for (unsigned int i = 0; i < 4; ++i)
    first.analysis.advance();
  second.analysis.resume(first.analysis.checkpoint());
  BOOST_TEST(second.analysis.time() == first.analysis.time());
  BOOST_TEST(second.analysis.run() == exit_status::done);
  BOOST_TEST(whole.analysis.model().tool_forces()[0][1] == second.analysis.model().tool_forces()[0][1]);
}

BOOST_AUTO_TEST_CASE(two_states_of_one_model_in_turn)
{
  // Two futures of the same blank, increment by increment in turn, in one analysis: each is what it is alone.
  Run alone, both;
  const auto force = [](const Run &run) { return run.analysis.model().tool_forces()[0][1]; };
  const auto go = [](Run &run, const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
      run.analysis.advance();
  };
  alone.analysis.begin();
  std::vector<double> expected;
  for (unsigned int i = 0; i < 8; ++i)
  {
    go(alone, 1);
    expected.push_back(force(alone));
  }
  both.analysis.begin();
  go(both, 2);
  State early = both.analysis.state();
  go(both, 3);
  State late = both.analysis.state();
  for (unsigned int i = 0; i < 3; ++i)
  {
    both.analysis.set_state(early);
    go(both, 1);
    BOOST_TEST(force(both) == expected[2 + i]);
    early = both.analysis.state();
    both.analysis.set_state(late);
    go(both, 1);
    BOOST_TEST(force(both) == expected[5 + i]);
    late = both.analysis.state();
  }
  // A state is a value: what happens to the run does not touch it, and another analysis goes on from it.
  Run other;
  other.analysis.set_state(early);
  BOOST_TEST(other.analysis.time() == early.time());
  go(other, 1);
  BOOST_TEST(force(other) == expected[5]);
  // It survives a stream.
  std::stringstream stream;
  late.save(stream);
  State again;
  again.load(stream);
  BOOST_TEST((again.model.body == late.model.body));
  BOOST_TEST(again.model.interfaces == late.model.interfaces);
  BOOST_TEST(again.n_iterations == late.n_iterations);
  BOOST_TEST(again.step.has_value() == late.step.has_value());
}

BOOST_AUTO_TEST_CASE(observers_are_told_in_their_order)
{
  Run run;
  std::string log;
  run.analysis.add(std::make_unique<Counter>(log));
  run.analysis.run();
  BOOST_TEST(log.rfind("begin before solved 1 before solved 2 ", 0) == 0u, log);
  BOOST_TEST(log.find(" end status 0") != std::string::npos, log);
}

BOOST_AUTO_TEST_CASE(observers_hear_that_the_run_has_gone_back)
{
  Run run;
  std::string log;
  run.analysis.add(std::make_unique<Counter>(log));
  run.analysis.begin();
  run.analysis.advance();
  const State first = run.analysis.state();
  run.analysis.advance();
  run.analysis.set_state(first);
  run.analysis.advance();
  BOOST_TEST(log == "begin before solved 1 before solved 2 moved to 1 before solved 2 ");
}

BOOST_AUTO_TEST_CASE(a_tool_that_does_not_find_the_blank_is_named)
{
  // The punch is driven by a force and begins away from the blank: downwards it finds it, sideways it passes.
  for (const bool sideways : {false, true})
  {
    ParameterTree tree = ParameterTree::parse(
      "", "test",
      pressed_strip({"Tools/punch/Force=t", "Tools/punch/Position z=2",
                     std::string("Tools/punch/Direction=") + (sideways ? "1 0" : "0 -1")}));
    Scene scene(tree);
    Timers timers;
    Model model(scene.actors, *scene.linear_solver, timers);
    const auto lost = model.begin_stage(scene.actors.stages.front());
    BOOST_TEST((lost == (sideways ? std::vector<std::string>{"punch"} : std::vector<std::string>())));
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_cannot_go_on_says_why)
{
  Run run;
  ParameterTree tree = ParameterTree::parse("", "test", pressed_strip({"Solver/Maximal increments=2"}));
  Scene scene(tree);
  Analysis analysis(scene.actors, scene.analysis_settings(), run.journal, run.timers);
  BOOST_TEST(analysis.run() == exit_status::not_converged);
  BOOST_TEST(analysis.message().find("2 increments are done") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
