// Every observer, told of a small run one at a time: what it writes, and that it needs none of the others.
#include "../messages.h"
#include "../pressed_strip.h"
#include "../solver/mpi.h"

#include <deltaform/analysis/analysis.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/reports/condition_numbers.h>
#include <deltaform/reports/history_columns.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/results/observers.h>
#include <deltaform/results/recorder.h>
#include <deltaform/scene/scene.h>

#include <filesystem>
#include <set>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  struct Run
  {
    explicit Run(const std::vector<std::string> &more = {}, const bool opened = true)
      : tree(ParameterTree::parse("", "test", entries(more))), scene(tree),
        journal(Journal::Console::plain, said, said),
        results(
          {folder.file("run_" + std::to_string(++n_runs)), scene.title, scene.units, true}, journal, timers),
        analysis(scene.actors, scene.analysis_settings(), journal, timers)
    {
      if (opened)
        results.begin([](std::ostream &out) { out << "the scene\n"; }, false);
    }

    static std::vector<std::string> entries(const std::vector<std::string> &more)
    {
      auto result = pressed_strip(
        {"Title=strip", "Steps/press/First increment=.1", "Output/Pictures=5", "Output/Travels=.025,.05"});
      result.insert(result.end(), more.begin(), more.end());
      return result;
    }

    int with(std::unique_ptr<Observer> observer)
    {
      analysis.add(std::move(observer));
      const int status = analysis.run();
      results.writer().wait();
      return status;
    }

    /// Files in the folder, but for what every folder has.
    std::set<std::string> files() const
    {
      std::set<std::string> result;
      for (const auto &file : std::filesystem::directory_iterator(results.name()))
        result.insert(file.path().filename().string());
      result.erase("scene.prm");
      result.erase("run.log");
      result.erase("deltaform.lock");
      return result;
    }

    inline static unsigned int n_runs = 0; ///< each has a folder of its own
    const TemporaryFolder folder;
    std::ostringstream said;
    Timers timers;
    ParameterTree tree;
    Scene scene;
    Journal journal;
    ResultsFolder results;
    Analysis analysis;
  };

  unsigned int n_lines(const std::string &text)
  {
    return static_cast<unsigned int>(std::count(text.begin(), text.end(), '\n'));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(observers)

BOOST_AUTO_TEST_CASE(nobody_looks_and_nothing_is_written)
{
  Run run;
  BOOST_TEST(run.analysis.run() == exit_status::done);
  BOOST_TEST(run.files().empty());
  BOOST_TEST(content_of(run.results.path("scene.prm")).find("the scene\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_folder_is_opened_when_the_run_begins)
{
  Run run({}, false);
  run.analysis.add(make_folder_observer(run.results, [](std::ostream &out) { out << "as it was read\n"; }));
  BOOST_TEST(!std::filesystem::exists(run.results.path("scene.prm")));
  run.analysis.begin();
  run.analysis.advance();
  run.results.writer().wait();
  BOOST_TEST(content_of(run.results.path("scene.prm")).find("as it was read\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_history_has_a_row_per_increment)
{
  Run run;
  Columns columns;
  describe_increment(columns);
  describe_tools({"punch"}, columns);
  BOOST_TEST(run.with(make_history_observer(run.results, columns, std::nullopt)) == exit_status::done);
  BOOST_TEST((run.files() == std::set<std::string>{"history.csv"}));
  const std::string text = content_of(run.results.path("history.csv"));
  const auto n_comments = static_cast<unsigned int>(std::count(text.begin(), text.end(), '#'));
  BOOST_TEST(n_lines(text) == n_comments + 1 + 10);
  BOOST_TEST(text.find("increment,stage,time,punch_travel,punch_force_z,punch_force_r\n") != std::string::npos);
  BOOST_TEST(text.find("\n10,press,1,0.05,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(tables_are_written_where_the_scene_asks)
{
  Run run;
  run.with(ObserverMakers::make("tables", run.results, *run.scene.output));
  BOOST_TEST((run.files() == std::set<std::string>{"profile_0.025.csv", "contact_0.025.csv", "tools_0.025.csv",
                                                   "profile_0.05.csv", "contact_0.05.csv", "tools_0.05.csv"}));
  BOOST_TEST(content_of(run.results.path("contact_0.05.csv")).find("punch,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(pictures_are_listed_in_their_series)
{
  Run run;
  run.with(ObserverMakers::make("pictures", run.results, *run.scene.output));
  unsigned int n_blanks = 0;
  for (const auto &file : run.files())
    n_blanks += file.rfind("blank_", 0) == 0;
  BOOST_TEST(n_blanks == 6u); // the undeformed one, and five
  BOOST_TEST(content_of(run.results.path("scene.pvd")).find("blank_0005.vtu") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(progress_is_shown_and_not_written)
{
  Run run;
  run.with(ObserverMakers::make("progress", run.results, *run.scene.output));
  BOOST_TEST(run.files().empty());
  BOOST_TEST(run.said.str().find("punch: travel 0.05, force ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_summary_says_how_it_ended)
{
  Run run;
  run.with(ObserverMakers::make("summary", run.results, *run.scene.output));
  BOOST_TEST((run.files() == std::set<std::string>{"summary.json", "timing.json"}));
  BOOST_TEST(earlier_exit_status(run.results.name()).value_or(-1) == exit_status::done);
  const std::string text = content_of(run.results.path("summary.json"));
  check_contains(text, {"\"title\": \"strip\"", "\"increments\": 10", "\"punch\"", "\"energy_error\""});

  Run stopped({"Solver/Maximal increments=3"});
  BOOST_TEST(stopped.with(ObserverMakers::make("summary", stopped.results, *stopped.scene.output)) ==
             exit_status::not_converged);
  check_contains(content_of(stopped.results.path("summary.json")),
                 {"\"exit_status\": 2", "3 increments are done", "\"increments\": 3"});
}

BOOST_AUTO_TEST_CASE(a_saved_state_can_be_read)
{
  Run run({"Solver/Maximal increments=3"});
  run.with(ObserverMakers::make("checkpoint", run.results, *run.scene.output));
  BOOST_TEST((run.files() == std::set<std::string>{"checkpoint.bin"}));
  const auto saved = Checkpoint::read(run.results.name());
  BOOST_REQUIRE(saved.has_value());
  BOOST_TEST(saved->increment == 3u);
  Run other;
  other.analysis.resume(*saved);
  BOOST_TEST(other.analysis.run() == exit_status::done);
  BOOST_TEST(other.analysis.time() == 1.);
}

BOOST_AUTO_TEST_CASE(condition_numbers_are_those_of_the_last_increment)
{
  Run run;
  auto report = std::make_unique<ConditionReport>(5, condition::Method::dense, run.journal, run.timers);
  Columns columns;
  describe_increment(columns);
  ConditionReport::describe(columns, report.get());
  run.analysis.add(std::move(report));
  run.with(make_history_observer(run.results, columns, std::nullopt));
  const std::string text = content_of(run.results.path("history.csv"));
  BOOST_TEST(text.find("\n4,press,0.4,,,,0,\n") != std::string::npos, text);
  BOOST_TEST(text.find("\n5,press,0.5,,") == std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(states_are_saved_when_all_else_is_written)
{
  Run run({"Output/Condition number every=5"});
  const auto all = make_observers(run.analysis.model(), *run.scene.output, run.results, nullptr);
  BOOST_TEST(all.size() == ObserverMakers::names().size() + 2); // history and condition numbers
  BOOST_TEST((all.front()->turn() == Observer::Turn::measures));
  BOOST_TEST((all.back()->turn() == Observer::Turn::saves));
  BOOST_TEST((all[all.size() - 2]->turn() == Observer::Turn::sums_up));
}

BOOST_AUTO_TEST_CASE(a_run_that_went_back_knows_where_it_is)
{
  // To half of the way, and from there once more: pictures and tables of the second half are written again.
  Run run;
  for (const auto *const name : {"tables", "pictures", "summary"})
    run.analysis.add(ObserverMakers::make(name, run.results, *run.scene.output));
  run.analysis.begin();
  for (unsigned int i = 0; i < 5; ++i)
    run.analysis.advance();
  const State half = run.analysis.state();
  for (unsigned int i = 0; i < 5; ++i)
    run.analysis.advance();
  run.analysis.set_state(half);
  BOOST_TEST(run.analysis.run() == exit_status::done);
  run.results.writer().wait();
  const auto files = run.files();
  BOOST_TEST(files.count("profile_0.05_press.csv") == 1u);
  BOOST_TEST(files.count("profile_0.025_press.csv") == 0u);
  BOOST_TEST(files.count("blank_0008.vtu") == 1u); // the undeformed one, five, and the last three again
  BOOST_TEST(files.count("blank_0009.vtu") == 0u);
}

BOOST_AUTO_TEST_CASE(a_record_is_what_the_files_are)
{
  Run run;
  RunRecord record;
  const auto columns = history_columns(run.analysis.model(), run.scene.output->energies, nullptr);
  run.analysis.add(make_history_observer(run.results, columns, std::nullopt));
  run.analysis.add(ObserverMakers::make("tables", run.results, *run.scene.output));
  run.with(make_recorder(record, columns, *run.scene.output, Keep::asked, []() { return 1.5; }));
  BOOST_TEST(record.history.size() == 10u);
  BOOST_REQUIRE_EQUAL(record.snapshots.size(), 2u);
  BOOST_TEST(record.snapshots[0].travel == .025, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(record.snapshots[1].stage == "press");
  check_contains(record.summary, {"\"increments\": 10", "\"seconds\": 1.5"});

  // The same rows, written by the same writer.
  const std::string again = run.results.path("again.csv");
  std::vector<CsvWriter::Column> heads;
  for (const auto &column : record.columns)
    heads.push_back({column.name, run.results.units().of(column.dimension)});
  CsvWriter file(again, run.results.comments(), heads);
  for (const auto &row : record.history)
    file.row_of_cells(row);
  BOOST_TEST(content_of(again) == content_of(run.results.path("history.csv")));
  BOOST_TEST(content_of(run.results.path("contact_0.05.csv")).find("tool,R0,penetration") != std::string::npos);
  BOOST_TEST(!record.snapshots[1].contact.rows.empty());

  Run every;
  RunRecord all;
  every.with(make_recorder(all, columns, *every.scene.output, Keep::every_increment, []() { return 0.; }));
  BOOST_TEST(all.snapshots.size() == 10u);
  Run stopped({"Solver/Maximal increments=3"});
  RunRecord part;
  stopped.with(make_recorder(part, columns, *stopped.scene.output, Keep::asked, []() { return 0.; }));
  BOOST_TEST(part.exit_status == exit_status::not_converged);
  BOOST_TEST(part.message.find("3 increments are done") != std::string::npos);
  BOOST_REQUIRE_EQUAL(part.snapshots.size(), 1u);
  BOOST_TEST(part.snapshots[0].time == .3, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(all_that_a_scene_asks_for)
{
  Run run;
  for (auto &observer : make_observers(run.analysis.model(), *run.scene.output, run.results, nullptr))
    run.analysis.add(std::move(observer));
  BOOST_TEST(run.analysis.run() == exit_status::done);
  const auto files = run.files();
  for (const auto *const name : {"history.csv", "profile_0.05.csv", "blank_0005.vtu", "scene.pvd", "summary.json",
                                 "timing.json", "checkpoint.bin"})
    BOOST_TEST(files.count(name) == 1u, name);
}

BOOST_AUTO_TEST_SUITE_END()
