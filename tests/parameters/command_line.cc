#include <deltaform/parameters/command_line.h>

#include "../messages.h"

using namespace deltaform;

namespace
{
  using Command = CommandLine::Command;

  CommandLine parse(std::vector<const char *> words)
  {
    words.insert(words.begin(), "deltaform");
    return CommandLine::parse(static_cast<int>(words.size()), words.data());
  }

  std::string complaint(const std::vector<const char *> &words)
  {
    return message_of<UsageError>([&words]() { parse(words); });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(command_line)

BOOST_AUTO_TEST_CASE(run)
{
  const auto line = parse({"cup.prm",
                           "--set",
                           "Contact/Allowed penetration=1e-4",
                           "--output",
                           "here",
                           "--set",
                           "Blank/Elements=-1",
                           "--quiet",
                           "--resume"});
  BOOST_CHECK(line.command == Command::run);
  BOOST_TEST(line.scene == "cup.prm");
  BOOST_TEST(line.sets == (std::vector<std::string>{"Contact/Allowed penetration=1e-4", "Blank/Elements=-1"}),
             boost::test_tools::per_element());
  BOOST_TEST(line.output == "here");
  BOOST_TEST(line.quiet);
  BOOST_TEST(line.resume);
  BOOST_TEST(!parse({"cup.prm"}).quiet);
}

BOOST_AUTO_TEST_CASE(other_commands)
{
  BOOST_CHECK(parse({"cup.prm", "--check"}).command == Command::check);
  BOOST_CHECK(parse({"--list"}).command == Command::list);
  BOOST_CHECK(parse({"--version"}).command == Command::version);
  BOOST_CHECK(parse({"--help"}).command == Command::help);
  BOOST_CHECK(parse({"-h", "cup.prm", "--list"}).command == Command::help);
  BOOST_CHECK(parse({"--print-parameters"}).command == Command::print_parameters);
  BOOST_TEST(parse({"--print-parameters"}).scene == "");
  BOOST_CHECK(parse({"--print-columns"}).command == Command::print_columns);
  BOOST_TEST(parse({"--print-parameters", "cup.prm"}).scene == "cup.prm");
  BOOST_TEST(parse({"./sweep"}).scene == "./sweep");
}

BOOST_AUTO_TEST_CASE(sweep)
{
  const auto line = parse({"sweep", "cup.prm", "--vary", "Contact/Allowed penetration=1e-3,1e-5, 1e-7", "--jobs", "2"});
  BOOST_CHECK(line.command == Command::sweep);
  BOOST_TEST(line.scene == "cup.prm");
  BOOST_TEST(line.jobs == 2u);
  BOOST_TEST(line.seconds == std::numeric_limits<double>::infinity());
  BOOST_TEST(parse({"sweep", "cup.prm", "--vary", "A/b=1", "--seconds", "2.5"}).seconds == 2.5);
  BOOST_REQUIRE_EQUAL(line.variations.size(), 1u);
  BOOST_TEST(line.variations[0].entry == "Contact/Allowed penetration");
  BOOST_TEST(line.variations[0].values == (std::vector<std::string>{"1e-3", "1e-5", "1e-7"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(ranges_of_varied_values)
{
  const auto values = [](const std::string &text) {
    return parse({"sweep", "a.prm", "--vary", ("A/b=" + text).c_str()}).variations[0].values;
  };
  using Strings = std::vector<std::string>;
  BOOST_TEST(values(".05:.2:.05") == (Strings{"0.05", "0.1", "0.15", "0.2"}), boost::test_tools::per_element());
  BOOST_TEST(values("3:1:-1") == (Strings{"3", "2", "1"}), boost::test_tools::per_element());
  BOOST_TEST(values("0:1:.4") == (Strings{"0", "0.4", "0.8"}), boost::test_tools::per_element());
  BOOST_TEST(values("1e-3, 1:2:1") == (Strings{"1e-3", "1", "2"}), boost::test_tools::per_element());
  BOOST_TEST(values("0:.3:.1") == (Strings{"0", "0.1", "0.2", "0.3"}), boost::test_tools::per_element());
  BOOST_TEST(values("5:5:1") == (Strings{"5"}), boost::test_tools::per_element());
  BOOST_TEST(values("0: 0, 1: 1;") == (Strings{"0: 0, 1: 1"}), boost::test_tools::per_element()); // a table
  BOOST_TEST(values("a:b:c") == (Strings{"a:b:c"}), boost::test_tools::per_element());
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1:2:-1"}),
                 {"A/b=1:2:-1", "a step of -1 does not lead from 1 to 2"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1:2:0"}), {"a step of 0 does not lead"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=0:1:1e-9"}), {"more than 10000 values"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=20e3:100e3"}), {"an interval needs --samples"});
}

BOOST_AUTO_TEST_CASE(new_and_explain)
{
  const auto line = parse({"new", "cup", "my.prm", "thickness=2", "blank radius=60"});
  BOOST_CHECK(line.command == Command::new_scene);
  BOOST_TEST(line.words == (std::vector<std::string>{"cup", "my.prm", "thickness=2", "blank radius=60"}),
             boost::test_tools::per_element());
  BOOST_TEST(parse({"new"}).words.empty());
  BOOST_CHECK(parse({"explain", "Blank/Layers"}).command == Command::explain);
  BOOST_TEST(parse({"./new"}).scene == "./new");
  BOOST_CHECK(parse({"new", "--help"}).command == Command::help);
  check_contains(complaint({"explain"}), {"explain needs one name"});
  check_contains(complaint({"new", "cup", "my.prm", "--quiet"}), {"--quiet does not go with 'deltaform new'"});
  check_contains(complaint({"explain", "a", "--set", "b=1"}), {"--set does not go with 'deltaform explain'"});
}

BOOST_AUTO_TEST_CASE(drawing_printing_and_going_on)
{
  BOOST_TEST(parse({"a.prm", "--check", "--svg", "a.svg"}).svg == "a.svg");
  BOOST_TEST(parse({"sweep", "a.prm", "--vary", "A/b=1", "--print"}).print);
  BOOST_TEST(parse({"sweep", "a.prm", "--vary", "A/b=1", "--resume"}).resume);
  check_contains(complaint({"a.prm", "--svg", "a.svg"}), {"--svg FILE goes with --check"});
  check_contains(complaint({"a.prm", "--print"}), {"--print goes with 'deltaform sweep"});
  check_contains(complaint({"a.prm", "--check", "--resume"}), {"--resume goes with a run or a sweep"});
}

BOOST_AUTO_TEST_CASE(varied_values_with_commas)
{
  const auto line = parse({"sweep", "a.prm", "--vary", "A/b=0: 0, 1: 1; 0: 0, 1: 2", "--vary", "A/c=0: 0, 1: 3;"});
  BOOST_REQUIRE_EQUAL(line.variations.size(), 2u);
  BOOST_TEST(line.variations[0].values == (std::vector<std::string>{"0: 0, 1: 1", "0: 0, 1: 2"}),
             boost::test_tools::per_element());
  BOOST_TEST(line.variations[1].values == (std::vector<std::string>{"0: 0, 1: 3"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_usage)
{
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1", "--vary", "A/b=2"}), {"A/b", "stated twice"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1;;2"}), {"value,value"});
  check_contains(complaint({}), {"No scene is named", "--help"});
  check_contains(complaint({"--check"}), {"No scene is named"});
  check_contains(complaint({"a.prm", "b.prm"}), {"'b.prm'", "too many"});
  check_contains(complaint({"--list", "b.prm"}), {"'b.prm'"});
  check_contains(complaint({"a.prm", "--quite"}), {"'--quite'", "'--quiet'"});
  check_contains(complaint({"a.prm", "--out", "x"}), {"'--out'", "'--output'"});
  check_contains(complaint({"a.prm", "--output"}), {"--output"});
  check_contains(complaint({"a.prm", "--set", "Blank/Elements"}), {"Section/Entry=value"});
  check_contains(complaint({"a.prm", "--check", "--list"}), {"--list", "--check", "exclude"});
  check_contains(complaint({"a.prm", "--check", "--resume"}), {"--resume"});
  check_contains(complaint({"a.prm", "--jobs", "2"}), {"sweep"});
  check_contains(complaint({"a.prm", "--seconds", "2"}), {"--seconds", "sweep"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1", "--seconds", "0"}), {"--seconds", "positive"});
  check_contains(complaint({"sweep", "a.prm"}), {"--vary"});
  check_contains(complaint({"sweep", "--vary", "A/b=1"}), {"No scene"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b="}), {"A/b="});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1,,2"}), {"value,value"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1", "--jobs", "0"}), {"at least 1"});
  check_contains(complaint({"sweep", "a.prm", "--vary", "A/b=1", "--jobs", "two"}), {"jobs"});
}

BOOST_AUTO_TEST_CASE(help_is_complete)
{
  check_contains(CommandLine::help(),
                 {"SCENE.prm",
                  "--set",
                  "--output",
                  "--check",
                  "--resume",
                  "--quiet",
                  "--list",
                  "--print-parameters",
                  "--print-columns",
                  "--version",
                  "--help",
                  "sweep",
                  "--vary",
                  "--jobs",
                  "--seconds",
                  "Exit status",
                  " 64 "});
}

BOOST_AUTO_TEST_SUITE_END()
