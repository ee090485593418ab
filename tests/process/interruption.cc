#include <deltaform/process/child_process.h>
#include <deltaform/process/interruption.h>

#include "../messages.h"

#include <csignal>
#include <limits>

using namespace deltaform;

namespace
{
  /// The exit status of a process that does @p job.
  int status_of(const std::function<int()> &job)
  {
    start_process(job, "/dev/null");
    return wait_for_process(std::numeric_limits<double>::infinity())->exit_status;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(interruption)

BOOST_AUTO_TEST_CASE(the_first_signal_is_remembered)
{
  for (const int signal : {SIGINT, SIGTERM, SIGXFSZ, SIGPIPE})
    BOOST_TEST(status_of([signal]() {
                 deltaform::interruption::watch();
                 const int before = deltaform::interruption::signal();
                 std::raise(signal);
                 return before == 0 ? deltaform::interruption::signal() : -1;
               }) == signal);
  BOOST_TEST(status_of([]() {
               deltaform::interruption::watch();
               std::raise(SIGPIPE);
               std::raise(SIGTERM);
               return deltaform::interruption::signal();
             }) == SIGPIPE);
  check_contains(deltaform::interruption::name(SIGTERM), {"signal 15 (Terminated)"});
}

BOOST_AUTO_TEST_CASE(the_second_one_ends_at_once)
{
  BOOST_TEST(status_of([]() {
               deltaform::interruption::watch();
               std::raise(SIGINT);
               return std::raise(SIGINT);
             }) == 128 + SIGINT);
}

BOOST_AUTO_TEST_CASE(what_is_ignored_stays_ignored)
{
  BOOST_TEST(status_of([]() {
               std::signal(SIGINT, SIG_IGN); // as by nohup
               deltaform::interruption::watch();
               std::raise(SIGINT);
               return deltaform::interruption::signal();
             }) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
