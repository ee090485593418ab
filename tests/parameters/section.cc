#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include "../messages.h"

#include <climits>

using namespace deltaform;

namespace
{
  /// What the reading of one entry of subsection A complains about, where the entry has the value @p value.
  template <typename Read>
  std::string complaint(const std::string &value, const Read &read)
  {
    ParameterTree tree(SceneFile::parse("\nsubsection A\n  set x = " + value + "\nend\n", "cup.prm"));
    Section section = tree.root().sub("A");
    return message_of<SceneError>([&]() { read(section); });
  }

  struct Shout
  {
    virtual ~Shout() = default;
    virtual std::string word() const = 0;
  };

  struct Loud : Shout
  {
    explicit Loud(Section &section)
      : volume(section.number("Volume", 11., Range::positive(), "1", "How loud."))
    {
    }
    std::string word() const override
    {
      return std::string(static_cast<std::size_t>(volume), '!');
    }
    double volume;
  };

  const Registry<Shout>::Entry entry("loud", "n exclamation marks", make_as<Loud, Shout>);
} // namespace

BOOST_AUTO_TEST_SUITE(section)

BOOST_AUTO_TEST_CASE(ranges)
{
  BOOST_TEST(Range::positive().to_string() == "(0, inf)");
  BOOST_TEST(Range::not_negative().to_string() == "[0, inf)");
  BOOST_TEST(Range::inside(-1., .5).to_string() == "(-1, 0.5)");
  BOOST_TEST(Range::any().to_string() == "(-inf, inf)");
  BOOST_TEST(!Range::positive().contains(0.));
  BOOST_TEST(Range::not_negative().contains(0.));
  BOOST_TEST(Range::between(0., 1.).contains(1.));
  BOOST_TEST(!Range::from_to_below(0., 1.).contains(1.));
  BOOST_TEST(Range::above_to(0., 1.).contains(1.));
}

BOOST_AUTO_TEST_CASE(values_of_every_kind)
{
  auto tree = ParameterTree::parse("subsection A\n"
                                   "  set number = 0.035/2\n"
                                   "  set integer = 1e3\n"
                                   "  set flag = yes\n"
                                   "  set text = words, and more\n"
                                   "  set choice = two\n"
                                   "  set names = punch, die\n"
                                   "  set numbers = 1, pi*0, 3\n"
                                   "  set rows = 0 0; 1 (1 + 1);\n"
                                   "  set function = 2*t*h\n"
                                   "end\n",
                                   "cup.prm",
                                   {"A/text=other words"});
  Section a = tree.root().sub("A");
  BOOST_TEST(a.number("number", required(1.), Range::positive(), "length", "A number.") == .0175);
  BOOST_TEST(a.number("number", required(1.), Range::positive(), "length", "A number.") == .0175);
  BOOST_TEST(a.integer("integer", 2, 1, INT_MAX, "An integer.") == 1000);
  BOOST_TEST(a.flag("flag", false, "A flag."));
  BOOST_TEST(a.text("text", "default", "A text.") == "other words");
  BOOST_TEST(a.choice("choice", "one", {"one", "two"}, "A choice.") == "two");
  BOOST_TEST(a.names("names", "", "Names.") == (std::vector<std::string>{"punch", "die"}),
             boost::test_tools::per_element());
  BOOST_TEST(a.numbers("numbers", "", "1", "Numbers.") == (std::vector<double>{1., 0., 3.}),
             boost::test_tools::per_element());
  const auto rows = a.rows("rows", required("0 0"), 2, "length", "Points.");
  BOOST_REQUIRE_EQUAL(rows.size(), 2u);
  BOOST_TEST(rows[1] == (std::vector<double>{1., 2.}), boost::test_tools::per_element());
  BOOST_TEST(a.function("function", "0", "length", "Travel.", {{"h", .5}})(3.) == 3.);

  BOOST_TEST(a.number("other", 4., Range::any(), "1", "Not in the scene.") == 4.);
  BOOST_TEST(a.given("number"));
  BOOST_TEST(!a.given("other"));
  BOOST_TEST(a.title() == "A");
  BOOST_TEST(a.sub("B").path() == "A/B");
  BOOST_TEST(!a.documentation());
  tree.check_unused();
}

BOOST_AUTO_TEST_CASE(a_value_in_quotes)
{
  for (const std::string quote : {"'", "\""})
    BOOST_TEST_CONTEXT("quote " << quote)
    {
      const auto entry = [&](const std::string &name, const std::string &value) {
        return " set " + name + " = " + quote + value + quote + "\n";
      };
      ParameterTree tree(SceneFile::parse("subsection A\n" + entry("table", "0: 0, 1: 1.2") + entry("function", "2*t") +
                                            entry("rows", "0 0; 1 2") + entry("numbers", "1, 2") +
                                            entry("number", ".5") + entry("names", "a, b") + "end\n",
                                          "cup.prm"));
      Section a = tree.root().sub("A");
      BOOST_TEST(a.function("table", "0", "length", "Travel.")(.5) == .6);
      BOOST_TEST(a.function("function", "0", "length", "Travel.")(.5) == 1.);
      const auto rows = a.rows("rows", required("0 0"), 2, "length", "Points.");
      BOOST_TEST_REQUIRE(rows.size() == 2u);
      BOOST_TEST(rows[1][1] == 2.);
      BOOST_TEST(a.numbers("numbers", "", "1", "Numbers.").back() == 2.);
      BOOST_TEST(a.number("number", 0., Range::any(), "1", "Number.") == .5);
      BOOST_TEST(a.names("names", "", "Names.").back() == "b");
      tree.check_unused();
    }
  const auto table = [](Section &s) { s.function("x", "0", "length", "Travel."); };
  check_contains(complaint("'0: 0, 1: 1.2", table), {"A/x = '0: 0, 1: 1.2"});
  check_contains(complaint("'0: 0, 1: 1.2\"", table), {"A/x"});
}

BOOST_AUTO_TEST_CASE(numbers_that_are_wrong)
{
  const auto thickness = [](Section &s) { s.number("x", required(.03), Range::positive(), "length", "Thick."); };
  BOOST_TEST(complaint("-1", thickness) == "cup.prm:3: A/x = -1: must lie in (0, inf) [length]. Thick.");
  check_contains(complaint("0", thickness), {"cup.prm:3: A/x = 0: must lie in (0, inf)"});
  check_contains(complaint("nan", thickness), {"cup.prm:3: A/x = nan:", "finite", "(0, inf)", "[length]"});
  check_contains(complaint("inf", thickness), {"A/x = inf:", "finite"});
  check_contains(complaint("0/0", thickness), {"A/x = 0/0:", "finite"});
  check_contains(complaint("thin", thickness), {"cannot evaluate 'thin'", "expected a number in (0, inf)"});
  check_contains(complaint("", thickness), {"A/x = :", "a number is missing"});
  check_contains(complaint(".5", [](Section &s) { s.number("x", .3, Range::inside(-1., .5), "1", "Ratio."); }),
                 {"A/x = .5: must lie in (-1, 0.5) [1]. Ratio."});
  const auto integer = [](Section &s) { s.integer("x", 7, 1, 15, "Layers."); };
  check_contains(complaint("2.5", integer), {"integer in [1, 15]"});
  check_contains(complaint("16", integer), {"must lie in [1, 15]", "Layers."});
}

BOOST_AUTO_TEST_CASE(other_kinds_that_are_wrong)
{
  check_contains(complaint("maybe", [](Section &s) { s.flag("x", true, "Flag."); }), {"cup.prm:3:", "true or false"});
  check_contains(complaint("adptive",
                           [](Section &s) {
                             s.choice("x", "paper", {"adaptive", "paper"}, "Rule.");
                           }),
                 {"cup.prm:3: A/x = adptive:", "one of adaptive, paper", "nearest: adaptive", "Rule."});
  check_contains(complaint("a, b, a", [](Section &s) { s.names("x", "", "Names."); }), {"'a' twice"});
  check_contains(complaint("a,, b", [](Section &s) { s.names("x", "", "Names."); }), {"comma"});
  check_contains(complaint("1, b", [](Section &s) { s.numbers("x", "", "1", "Numbers."); }), {"'b'"});
  check_contains(complaint("0 0; 1", [](Section &s) { s.rows("x", "", 2, "length", "Points."); }),
                 {"row '1' has 1 numbers", "rows of 2 numbers", "[length]"});
  check_contains(complaint("0: 0, 0: 1", [](Section &s) { s.function("x", "0", "length", "Travel."); }),
                 {"cup.prm:3: A/x", "must increase", "[length]. Travel."});
  check_contains(complaint("", [](Section &s) { s.text("x", required("a"), "Text."); }), {"must not be empty"});
}

BOOST_AUTO_TEST_CASE(missing_entries)
{
  const auto read = [](const std::string &content) {
    auto tree = ParameterTree::parse(content, "cup.prm");
    return message_of<SceneError>(
      [&tree]() {
        tree.root().sub("Blank").number("Thickness", required(.035), Range::positive(), "length", "Initial thickness.");
      });
  };
  check_contains(read("\nsubsection Blank\nend\n"),
                 {"cup.prm: Blank/Thickness is required",
                  "Initial thickness.",
                  "'set Thickness = ...'",
                  "0.035",
                  "[length]",
                  "(0, inf)",
                  "subsection Blank (line 2)"});
  check_contains(read(""), {"Blank/Thickness is required", "subsection Blank, which the scene does not have"});
  check_contains(read("subsection Blank\n set Thicknes = 1\nend\n"), {"meant by Blank/Thicknes (cup.prm:2)"});
  check_contains(read("subsection Material\n set Thickness = 1\nend\n"), {"meant by Material/Thickness (cup.prm:2)"});
}

BOOST_AUTO_TEST_CASE(fail_names_the_place)
{
  auto tree = ParameterTree::parse("subsection Tools\n subsection punch\n  set Radius = 2\n end\nend\n", "cup.prm");
  Section punch = tree.root().sub("Tools").sub("punch");
  punch.number("Edge radius", .1, Range::positive(), "length", "Edge.");
  const auto complaint_of = [](const Section &section, const std::string &name) {
    return message_of<SceneError>([&]() { section.fail(name, "does not fit."); });
  };
  BOOST_TEST(complaint_of(punch, "Radius") == "cup.prm:3: Tools/punch/Radius = 2: does not fit.");
  BOOST_TEST(complaint_of(punch, "Edge radius") ==
             "cup.prm:2: Tools/punch/Edge radius = 0.1 (the default): does not fit.");
  BOOST_TEST(complaint_of(tree.root().sub("Tools"), "punch") == "cup.prm:2: Tools/punch: does not fit.");
}

BOOST_AUTO_TEST_CASE(registry_chooses_and_makes)
{
  auto tree = ParameterTree::parse("set Kind = loud\nset Volume = 3\n", "cup.prm");
  Section root = tree.root();
  const auto it = Registry<Shout>::choose(root, "Kind", "loud", "What is shouted.");
  BOOST_TEST(it->word() == "!!!");
  tree.check_unused();
  BOOST_TEST(Registry<Shout>::names().size() == 1u);

  auto documentation = ParameterTree::documentation();
  Section section = documentation.root().sub("Shout");
  BOOST_TEST(section.documentation());
  BOOST_TEST(Registry<Shout>::make("loud", section)->word().size() == 11u);

  // A name is taken once.
  const auto again = []() { const Registry<Shout>::Entry second("loud", "again", make_as<Loud, Shout>); };
  BOOST_CHECK_THROW(again(), std::logic_error);
  BOOST_TEST(Registry<Shout>::sentence("loud") == "n exclamation marks");
}

BOOST_AUTO_TEST_SUITE_END()
