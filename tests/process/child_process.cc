#include <deltaform/process/child_process.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <set>
#include <stdexcept>
#include <thread>

using namespace deltaform;

namespace
{
  constexpr double forever = std::numeric_limits<double>::infinity();
}

BOOST_AUTO_TEST_SUITE(child_process)

BOOST_AUTO_TEST_CASE(status_signal_and_console)
{
  const std::string console = (std::filesystem::temp_directory_path() / "deltaform_child_process.txt").string();
  const auto talk = []() {
    std::cout << "said\n";
    std::cout.flush();
    std::cerr << "complained\n";
    return 3;
  };
  start_process(talk, console);
  BOOST_TEST(wait_for_process(forever)->exit_status == 3);
  std::ifstream file(console);
  std::string first, second;
  std::getline(file, first);
  std::getline(file, second);
  BOOST_TEST(first == "said");
  BOOST_TEST(second == "complained");
  std::filesystem::remove(console);

  start_process([]() { return std::raise(SIGKILL); }, "/dev/null");
  BOOST_TEST(wait_for_process(forever)->exit_status == 128 + 9);
}

BOOST_AUTO_TEST_CASE(each_process_is_told_apart)
{
  const auto fail = []() { return 1; };
  const std::set<int> started{start_process(fail, "/dev/null"), start_process(fail, "/dev/null")};
  std::set<int> ended;
  for (unsigned int i = 0; i < 2; ++i)
    ended.insert(wait_for_process(forever)->process);
  BOOST_TEST((started == ended));
  BOOST_CHECK_THROW(wait_for_process(forever), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(waiting_has_an_end)
{
  const auto sleep = []() {
    std::this_thread::sleep_for(std::chrono::seconds(100));
    return 0;
  };
  const int process = start_process(sleep, "/dev/null");
  BOOST_CHECK(!wait_for_process(.02));
  end_process(process);
  const auto ended = wait_for_process(10.);
  BOOST_REQUIRE(ended.has_value());
  BOOST_TEST(ended->process == process);
  BOOST_TEST(ended->exit_status == 128 + 9);
}

BOOST_AUTO_TEST_CASE(the_copy_has_what_was_there_and_leaves_it_alone)
{
  int number = 41;
  const auto job = [&number]() { return ++number; };
  start_process(job, "/dev/null");
  BOOST_TEST(wait_for_process(forever)->exit_status == 42);
  BOOST_TEST(number == 41);
}

BOOST_AUTO_TEST_CASE(an_exception_is_a_failure)
{
  const auto job = []() -> int { throw std::runtime_error("no"); };
  start_process(job, "/dev/null");
  BOOST_TEST(wait_for_process(forever)->exit_status == 1);
}

BOOST_AUTO_TEST_CASE(missing_folder)
{
  BOOST_CHECK_THROW(start_process([]() { return 0; }, "/no/such/folder/console.txt"), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
