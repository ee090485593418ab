#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/journal.h>

#include "../messages.h"

#include <chrono>
#include <thread>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(journal)

BOOST_AUTO_TEST_CASE(plain_lines_and_log)
{
  const TemporaryFolder folder;
  const auto path = folder.file("run.log");
  std::ostringstream out, warnings;
  Journal journal(Journal::Console::plain, out, warnings);
  journal.note("before");
  journal.open_log(path);
  journal.progress("10 %");
  journal.note("cut back");
  journal.warning("thin");
  journal.detail("only logged");
  // Read while the journal lives: every line is on disk at once.
  BOOST_TEST(content_of(path) == "before\ncut back\nwarning: thin\nonly logged\n");
  BOOST_TEST(out.str() == "before\n10 %\ncut back\n");
  BOOST_TEST(warnings.str() == "warning: thin\n");
  BOOST_TEST(journal.n_warnings() == 1u);
}

BOOST_AUTO_TEST_CASE(terminal_rewrites_one_line)
{
  std::ostringstream out, warnings;
  {
    Journal journal(Journal::Console::terminal, out, warnings);
    journal.progress("10 %");
    journal.progress("20 %");
    journal.note("note");
    journal.progress("30 %");
  }
  BOOST_TEST(out.str() == "\r\033[K10 %\r\033[K20 %\r\033[Knote\n\r\033[K30 %\n");
}

BOOST_AUTO_TEST_CASE(progress_is_wanted_where_somebody_can_read_it)
{
  std::ostringstream out;
  Journal terminal(Journal::Console::terminal, out, out);
  BOOST_TEST(terminal.wants_progress());
  const auto start = std::chrono::steady_clock::now();
  terminal.progress("10 %");
  const bool again = terminal.wants_progress();
  if (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(50))
    BOOST_TEST(!again);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  BOOST_TEST(terminal.wants_progress());
  terminal.progress("20 %");
  terminal.note("erased it");
  BOOST_TEST(terminal.wants_progress());

  Journal plain(Journal::Console::plain, out, out);
  plain.progress("10 %");
  BOOST_TEST(plain.wants_progress()); // every line
  BOOST_TEST(!Journal(Journal::Console::quiet, out, out).wants_progress());
  BOOST_TEST(!Journal(Journal::Console::silent, out, out).wants_progress());
}

BOOST_AUTO_TEST_CASE(quiet_and_silent)
{
  for (const auto console : {Journal::Console::quiet, Journal::Console::silent})
  {
    std::ostringstream out, warnings;
    Journal journal(console, out, warnings);
    journal.progress("10 %");
    journal.note("note");
    journal.warning("thin");
    BOOST_TEST(out.str() == "");
    BOOST_TEST(warnings.str() == (console == Journal::Console::quiet ? "warning: thin\n" : ""));
  }
}

BOOST_AUTO_TEST_CASE(log_that_cannot_be_written)
{
  std::ostringstream out;
  Journal journal(Journal::Console::plain, out, out);
  check_contains(message_of<SceneError>([&journal]() { journal.open_log("/nonexistent/run.log"); }),
                 {"/nonexistent/run.log", "No such file"});
}

BOOST_AUTO_TEST_SUITE_END()
