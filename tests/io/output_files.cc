#include <deltaform/io/atomic_file.h>
#include <deltaform/io/background_writer.h>
#include <deltaform/io/csv_writer.h>
#include <deltaform/io/result_error.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/timers.h>

#include "../messages.h"

#include <deal.II/base/exceptions.h>

#include <boost/property_tree/json_parser.hpp>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(output_files)

BOOST_AUTO_TEST_CASE(csv_is_on_disk_after_every_row)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  CsvWriter csv(path, {"forces for the full circumference"}, {{"increment"}, {"punch_travel", "length"}});
  const std::string head = "# forces for the full circumference\n# units: 1,length\nincrement,punch_travel\n";
  BOOST_TEST(content_of(path) == head);
  csv.row({1., 1. / 3.});
  BOOST_TEST(content_of(path) == head + "1,0.3333333333\n");
  csv.row_of_cells({std::string("a, \"b\""), -1e-9});
  BOOST_TEST(content_of(path) == head + "1,0.3333333333\n\"a, \"\"b\"\"\",-1e-09\n");
  BOOST_CHECK_THROW(csv.row({1.}), dealii::ExceptionBase);
}

BOOST_AUTO_TEST_CASE(only_finite_numbers_get_into_a_file)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  CsvWriter csv(path, {}, {{"increment"}, {"force"}});
  csv.row_of_cells({1., std::string()}); // not known
  const std::string before = content_of(path);
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL})
  {
    check_contains(message_of<ResultError>([&]() { csv.row({2., value}); }), {"force of '", "is no finite number"});
    check_contains(message_of<ResultError>([&]() { csv.row_of_cells({2., value}); }), {"force of '"});
  }
  BOOST_TEST(content_of(path) == before);
  csv.row({2., 3.});
  BOOST_TEST(content_of(path) == before + "2,3\n");
}

BOOST_AUTO_TEST_CASE(a_table_goes_on)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv", "a,b\n1,2\n");
  CsvWriter csv = CsvWriter::append(path, {{"a"}, {"b"}});
  csv.row({3., 4.});
  BOOST_TEST(content_of(path) == "a,b\n1,2\n3,4\n");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written_is_named)
{
  check_contains(message_of<SceneError>([]() { CsvWriter("/nonexistent/history.csv", {}, {{"x"}}); }),
                 {"/nonexistent/history.csv", "No such file"});
  check_contains(message_of<SceneError>([]() { write_file_atomically("/nonexistent/a", [](std::ostream &) {}); }),
                 {"'/nonexistent/a'", "No such file"});
}

BOOST_AUTO_TEST_CASE(whole_files_are_replaced_or_kept)
{
  const TemporaryFolder folder;
  const auto path = folder.file("summary.json", "old");
  write_file_atomically(path, [](std::ostream &out) { out << "new"; });
  BOOST_TEST(content_of(path) == "new");
  BOOST_CHECK_THROW(write_file_atomically(path,
                                          [](std::ostream &out) {
                                            out << "half";
                                            throw std::runtime_error("stopped");
                                          }),
                    std::runtime_error);
  BOOST_TEST(content_of(path) == "new");
  BOOST_TEST(!std::filesystem::exists(path + ".part"));
}

BOOST_AUTO_TEST_CASE(files_are_written_behind)
{
  // The caller goes on while the first task waits for what the caller says; tasks keep their order.
  std::mutex mutex;
  std::condition_variable said;
  bool go = false;
  std::string order;
  std::thread::id writer;
  BackgroundWriter files;
  files.wait(); // nothing to wait for
  files.run(
    [&]() {
      std::unique_lock<std::mutex> lock(mutex);
      said.wait(lock, [&]() { return go; });
      writer = std::this_thread::get_id();
      order += "a";
    });
  {
    const std::lock_guard<std::mutex> lock(mutex);
    BOOST_TEST(order.empty());
    go = true;
  }
  said.notify_one();
  files.run([&]() { order += "b"; });
  files.wait();
  BOOST_TEST(order == "ab");
  BOOST_TEST((writer != std::this_thread::get_id()));

  // What goes wrong is heard of, and what was to follow is not done.
  files.run([]() { throw SceneError("the disk is full"); });
  check_contains(message_of<SceneError>(
                   [&]() {
                     files.run([&]() { order += "c"; });
                     files.wait();
                   }),
                 {"the disk is full"});
  BOOST_TEST(order == "ab");
}

BOOST_AUTO_TEST_CASE(a_slow_disk_holds_up_nothing_until_four_tasks_wait)
{
  std::promise<void> disk;
  const auto ready = disk.get_future().share();
  std::string order;
  BackgroundWriter files;
  std::promise<void> four;
  auto caller = std::async(std::launch::async,
                           [&]() {
                             for (const char *const name : {"a", "b", "c", "d"})
                               files.run(
                                 [&order, ready, name]() {
                                   ready.wait();
                                   order += name;
                                 });
                             four.set_value();
                             files.run([&order]() { order += "e"; });
                           });
  // Four were taken while nothing could be written; a fifth has to wait for the first.
  BOOST_TEST((four.get_future().wait_for(std::chrono::seconds(20)) == std::future_status::ready));
  BOOST_TEST((caller.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout));
  disk.set_value();
  caller.get();
  files.wait();
  BOOST_TEST(order == "abcde");
}

BOOST_AUTO_TEST_CASE(timers_count_calls_and_seconds)
{
  Timers timers;
  const auto solve = timers.section("11 solve");
  const auto cells = timers.section("3 \"cells\"");
  BOOST_TEST(timers.section("11 solve") == solve);
  for (int i = 0; i < 3; ++i)
    const Timers::Scope scope(timers, solve);
  timers.add(cells, 2.5);
  BOOST_TEST(timers.calls(solve) == 3u);
  BOOST_TEST(timers.seconds(solve) >= 0.);
  BOOST_TEST(timers.seconds(cells) == 2.5);

  std::stringstream json;
  timers.write_json(json);
  boost::property_tree::ptree tree;
  boost::property_tree::read_json(json, tree);
  BOOST_TEST(tree.get<double>("total") >= 0.);
  const auto &sections = tree.get_child("sections");
  BOOST_REQUIRE_EQUAL(sections.size(), 2u);
  BOOST_TEST(sections.back().second.get<std::string>("name") == "3 \"cells\"");
  BOOST_TEST(sections.back().second.get<double>("seconds") == 2.5);
  BOOST_TEST(sections.front().second.get<int>("calls") == 3);
}

BOOST_AUTO_TEST_CASE(a_remainder_is_what_no_part_has_measured)
{
  using namespace std::chrono;
  Timers timers;
  const auto part = timers.section("part"), rest = timers.section("rest");
  const auto wait = [](const int milli) {
    for (const auto start = steady_clock::now(); steady_clock::now() - start < milliseconds(milli);)
      ;
  };
  const auto start = steady_clock::now();
  for (int i = 0; i < 2; ++i)
  {
    const Timers::Remainder remainder(timers, rest);
    for (int k = 0; k < 2; ++k)
    {
      wait(1);
      const Timers::Scope scope(timers, part);
      wait(5);
    }
  }
  const double elapsed = duration<double>(steady_clock::now() - start).count();
  BOOST_TEST(timers.calls(rest) == 2u);
  BOOST_TEST(timers.seconds(part) >= .020);
  BOOST_TEST(timers.seconds(rest) >= .0039);
  // The clock may stand still for other work, but not count twice.
  BOOST_TEST(timers.seconds(part) + timers.seconds(rest) <= elapsed);
  BOOST_TEST(timers.seconds(part) + timers.seconds(rest) >= .9 * elapsed);
}

BOOST_AUTO_TEST_SUITE_END()
