#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/scene_file.h>

#include "../messages.h"

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(scene_file)

BOOST_AUTO_TEST_CASE(statements_comments_and_continuation)
{
  const auto scene = SceneFile::parse("# a paragraph\n"
                                      "set Title = Cup # of the paper\n"
                                      "subsection  Tools\n"
                                      "  subsection punch\n"
                                      "    set Profile = 0 0; \\\n"
                                      "                  # the corner\n"
                                      "                  1 0; \\\n"
                                      "                  1 2\n"
                                      "    SET  Friction   coefficient=.2\r\n"
                                      "    set Empty =\n"
                                      "  end\n"
                                      "END",
                                      "cup.prm");
  BOOST_REQUIRE_EQUAL(scene.entries.size(), 4u);
  BOOST_TEST(scene.find({}, "Title")->value == "Cup");
  BOOST_TEST(scene.find({}, "Title")->origin.to_string() == "cup.prm:2");
  const auto *const profile = scene.find({"Tools", "punch"}, "Profile");
  BOOST_REQUIRE(profile != nullptr);
  BOOST_TEST(profile->value == "0 0; 1 0; 1 2");
  BOOST_TEST(profile->origin.line == 5u);
  BOOST_TEST(scene.find({"Tools", "punch"}, "Friction coefficient")->value == ".2");
  BOOST_TEST(scene.find({"Tools", "punch"}, "Friction coefficient")->origin.line == 9u);
  BOOST_TEST(scene.find({"Tools", "punch"}, "Empty")->value == "");
  BOOST_TEST(scene.find({"Tools", "punch"})->origin.line == 4u);
  BOOST_TEST(scene.find({"Tools"}, "Profile") == nullptr);
}

BOOST_AUTO_TEST_CASE(broken_syntax_names_file_and_line)
{
  const auto complaint = [](const std::string &content) {
    return message_of<SceneError>([&content]() { SceneFile::parse(content, "cup.prm"); });
  };
  check_contains(complaint("\nsett Title = x\n"), {"cup.prm:2:", "cannot understand 'sett Title = x'"});
  check_contains(complaint("set Title x"), {"cup.prm:1:", "set ENTRY = VALUE"});
  check_contains(complaint("set = x"), {"cup.prm:1:"});
  check_contains(complaint("subsection\n"), {"cup.prm:1:"});
  check_contains(complaint("subsection A\nend A\nend"), {"cup.prm:2:", "'end A'"});
  check_contains(complaint("subsection A\nend\n\nend\n"), {"cup.prm:4:", "'end' closes no subsection"});
  check_contains(complaint("\nsubsection A\nsubsection B\nend\n"), {"cup.prm:2:", "subsection A", "'end' is missing"});
}

BOOST_AUTO_TEST_CASE(twice_in_a_file_names_both_lines)
{
  const auto message = message_of<SceneError>(
    []() { SceneFile::parse("subsection A\n set x = 1\nend\nsubsection A\n set x = 2\nend\n", "cup.prm"); });
  check_contains(message, {"cup.prm:5:", "A/x", "line 2"});
}

BOOST_AUTO_TEST_CASE(include_is_relative_and_may_be_overridden)
{
  const TemporaryFolder folder;
  folder.file("parts/steel.prm", "set Young's modulus = 1\nset Poisson's ratio = .3\ninclude deep/more.prm\n");
  folder.file("parts/deep/more.prm", "set More = 1\n");
  const auto cup = folder.file("cup.prm",
                               "subsection Material\n"
                               "  set Poisson's ratio = .1\n"
                               "  include parts/steel.prm\n"
                               "  set Young's modulus = 2\n"
                               "end\n");
  const auto scene = SceneFile::read(cup);
  BOOST_TEST(scene.entries.size() == 3u);
  BOOST_TEST(scene.find({"Material"}, "Young's modulus")->value == "2"); // the later one
  BOOST_TEST(scene.find({"Material"}, "Young's modulus")->origin.to_string() == cup + ":4");
  BOOST_TEST(scene.find({"Material"}, "Poisson's ratio")->value == ".3");
  BOOST_TEST(scene.find({"Material"}, "Poisson's ratio")->origin.to_string() == folder.file("parts/steel.prm") + ":2");
  BOOST_TEST(scene.find({"Material"}, "More") != nullptr);
}

BOOST_AUTO_TEST_CASE(include_that_cannot_work)
{
  const TemporaryFolder folder;
  const auto read = [](const std::string &name) {
    return message_of<SceneError>([&name]() { SceneFile::read(name); });
  };
  const auto missing = folder.file("missing.prm", "\ninclude nowhere.prm\n");
  check_contains(read(missing), {"missing.prm:2:", "nowhere.prm", "cannot be read", "No such file"});

  const auto first = folder.file("first.prm", "include second.prm\n");
  folder.file("second.prm", "\n\ninclude ./first.prm\n");
  check_contains(read(first), {"second.prm:3:", "cycle", "first.prm -> "});

  const auto outer = folder.file("outer.prm", "subsection A\ninclude inner.prm\nend\n");
  folder.file("inner.prm", "end\nsubsection A\n");
  check_contains(read(outer), {"inner.prm:1:", "of this file"});

  check_contains(read(folder.file("absent.prm")), {"absent.prm: cannot be read: No such file"});
  check_contains(read(folder.path.string()), {"cannot be read", "folder"});
}

BOOST_AUTO_TEST_CASE(overrides)
{
  auto scene = SceneFile::parse("subsection A\nset x = 1\nend\n", "cup.prm");
  scene.override_entry("A/x = 2");
  scene.override_entry("A/Inner part/y=a=b");
  scene.override_entry("z=3");
  BOOST_TEST(scene.find({"A"}, "x")->value == "2");
  BOOST_TEST(scene.find({"A"}, "x")->origin.to_string() == "--set");
  BOOST_TEST(scene.find({"A", "Inner part"}, "y")->value == "a=b");
  BOOST_TEST(scene.find({}, "z")->value == "3");
  const auto complaint = [&scene](const std::string &text) {
    return message_of<SceneError>([&]() { scene.override_entry(text); });
  };
  check_contains(complaint("A/x"), {"--set \"A/x\"", "Section/Entry=value"});
  check_contains(complaint("A/=1"), {"Section/Entry=value"});
  check_contains(complaint("A/x=1 # one"), {"'#'"});
}

BOOST_AUTO_TEST_SUITE_END()
