// An analysis as a program uses it that is not ours: one increment at a time, no files.
#include <deltaform/analysis/analysis.h>
#include <deltaform/base/command_line.h>
#include <deltaform/base/parameter_tree.h>
#include <deltaform/model/accepted_increment.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace deltaform;

namespace
{
  /// A strip that is pressed flat between a plate and a round punch.
  const std::vector<std::string> entries = {"Blank/Points=0 0; 1 0",
                                            "Blank/Thickness=.02",
                                            "Blank/Elements=16",
                                            "Material/Model=linear elastic",
                                            "Material/Young's modulus=1e4",
                                            "Material/Poisson's ratio=.3",
                                            "Supports/Names=edge",
                                            "Supports/edge/Boundary=end",
                                            "Supports/edge/Component=z",
                                            "Tools/Names=punch",
                                            "Tools/punch/Shape=hemispherical punch",
                                            "Tools/punch/Radius=.5",
                                            "Tools/punch/Side=top",
                                            "Tools/punch/Position z=thickness/2",
                                            "Tools/punch/Motion=.05*t",
                                            "Steps/Stages=press",
                                            "Steps/press/Largest increment=.1"};

  struct Run
  {
    Run()
      : tree(ParameterTree::parse("", "test", entries)), scene(tree), journal(Journal::Console::silent, said, said),
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

    void begin(const FormingProblem &, const Stage &) override
    {
      log += "begin ";
    }
    void before(FormingProblem &, unsigned int) override
    {
      log += "before ";
    }
    void solved(FormingProblem &, const Vector &) override
    {
      log += "solved ";
    }
    void accepted(const AcceptedIncrement &increment) override
    {
      log += std::to_string(increment.number) + (increment.ends_stage ? " end " : " ");
    }
    void ended(const FormingProblem &, const RunOutcome &outcome) override
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

BOOST_AUTO_TEST_CASE(observers_are_told_in_their_order)
{
  Run run;
  std::string log;
  run.analysis.add(std::make_unique<Counter>(log));
  run.analysis.run();
  BOOST_TEST(log.rfind("begin before solved 1 before solved 2 ", 0) == 0u, log);
  BOOST_TEST(log.find(" end status 0") != std::string::npos, log);
}

BOOST_AUTO_TEST_CASE(a_run_that_cannot_go_on_says_why)
{
  Run run;
  ParameterTree tree = ParameterTree::parse("", "test", [] {
    auto all = entries;
    all.insert(all.end(), {"Solver/Maximal increments=2"});
    return all;
  }());
  Scene scene(tree);
  Analysis analysis(scene.actors, scene.analysis_settings(), run.journal, run.timers);
  BOOST_TEST(analysis.run() == exit_status::not_converged);
  BOOST_TEST(analysis.message().find("2 increments are done") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
