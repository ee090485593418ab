#include <deltaform/base/child_process.h>

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

using namespace deltaform;

namespace
{
  constexpr double forever = std::numeric_limits<double>::infinity();
}

BOOST_AUTO_TEST_SUITE(child_process)

BOOST_AUTO_TEST_CASE(status_signal_and_console)
{
  const std::string console = (std::filesystem::temp_directory_path() / "deltaform_child_process.txt").string();
  start_process({"/bin/sh", "-c", "echo said; echo complained >&2; exit 3"}, console);
  BOOST_TEST(wait_for_process(forever)->exit_status == 3);
  std::ifstream file(console);
  std::string first, second;
  std::getline(file, first);
  std::getline(file, second);
  BOOST_TEST(first == "said");
  BOOST_TEST(second == "complained");
  std::filesystem::remove(console);

  start_process({"/bin/sh", "-c", "kill -9 $$"}, "/dev/null");
  BOOST_TEST(wait_for_process(forever)->exit_status == 128 + 9);
}

BOOST_AUTO_TEST_CASE(each_process_is_told_apart)
{
  const std::set<int> started{start_process({"/bin/sh", "-c", "exit 1"}, "/dev/null"),
                              start_process({"/bin/sh", "-c", "exit 1"}, "/dev/null")};
  std::set<int> ended;
  for (unsigned int i = 0; i < 2; ++i)
    ended.insert(wait_for_process(forever)->process);
  BOOST_TEST((started == ended));
  BOOST_CHECK_THROW(wait_for_process(forever), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(waiting_has_an_end)
{
  const int process = start_process({"/bin/sleep", "100"}, "/dev/null");
  BOOST_CHECK(!wait_for_process(.02));
  end_process(process);
  const auto ended = wait_for_process(10.);
  BOOST_REQUIRE(ended.has_value());
  BOOST_TEST(ended->process == process);
  BOOST_TEST(ended->exit_status == 128 + 9);
}

BOOST_AUTO_TEST_CASE(missing_program)
{
  BOOST_CHECK_THROW(start_process({"/no/such/program"}, "/dev/null"), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
