#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <deal.II/base/parameter_handler.h>

#include "../messages.h"

using namespace deltaform;

namespace
{
  /// Declares what a small scene would, and returns what it reads.
  std::string declare_everything(ParameterTree &tree)
  {
    Section root = tree.root();
    Section blank = root.sub("Blank");
    Section contact = root.sub("Contact");
    Section punch = root.sub("Tools").sub("punch");
    const auto title = root.text("Title", "Cup", "What this is | shown in plots.");
    const auto thick = blank.number("Thickness", required(.035), Range::positive(), "length", "Initial thickness.");
    const auto n = blank.integer("Elements", 50, 1, 100000, "Elements along the meridian.");
    const auto rule = contact.choice("Penalty rule", "adaptive", {"adaptive", "paper"}, "Rule.");
    const auto depth = contact.number("Allowed penetration", 1e-3, Range::positive(), "length", "Delta.");
    const auto path = punch.function("Motion", "t", "length", "Travel.");
    const auto empty = punch.text("Note", "", "Anything.");
    std::ostringstream values;
    values << title << '|' << thick << '|' << n << '|' << rule << '|' << depth << '|' << path(.5) << '|' << empty;
    return values.str();
  }

  std::string strict_complaint(const std::string &content, const std::vector<std::string> &overrides = {})
  {
    auto tree = ParameterTree::parse(content, "cup.prm", overrides);
    declare_everything(tree);
    return message_of<SceneError>([&tree]() { tree.check_unused(); });
  }

  const std::string blank = "subsection Blank\n set Thickness = 0.07/2\nend\n"; // three lines
} // namespace

BOOST_AUTO_TEST_SUITE(parameter_tree)

BOOST_AUTO_TEST_CASE(a_subsection_that_no_list_names)
{
  const auto complaint = [](const std::string &content, const std::vector<std::string> &overrides = {}) {
    auto tree = ParameterTree::parse(content, "cup.prm", overrides);
    const auto each_has = [&](const std::string &outer, const std::string &list) {
      Section section = tree.root().sub(outer);
      for (const auto &name : section.names(list, list == "Stages" ? "form" : "", "Names."))
        section.sub(name).names("Stages", "", "Stages of a tool, end of a stage.");
    };
    each_has("Supports", "Names");
    each_has("Tools", "Names");
    each_has("Steps", "Stages");
    return message_of<SceneError>([&]() { tree.check_unused(); });
  };
  BOOST_TEST(complaint("subsection Supports\n set Names = left\n subsection floor\n end\nend\n") ==
             "cup.prm:3: unknown subsection Supports/floor: subsection 'floor' is not in Supports/Names = left: add it "
             "there or remove the subsection.");
  check_contains(complaint("subsection Supports\n subsection floor\n end\nend\n"),
                 {"'floor' is not in Supports/Names, which is empty: add it there"});
  check_contains(complaint("subsection Steps\n subsection release\n end\nend\n"),
                 {"'release' is not in Steps/Stages = form: add it there"});
  check_contains(complaint("", {"Supports/floor/Value=1"}), {"'floor' is not in Supports/Names", "add it there"});
  // The stages of a tool have no subsections in the tool.
  const auto inside = complaint("subsection Tools\n set Names = punch\n subsection punch\n  set Stages = form\n"
                                "  subsection form\n  end\n end\nend\n");
  check_contains(inside, {"cup.prm:5: unknown subsection Tools/punch/form.", "There is no subsection here."});
}

BOOST_AUTO_TEST_CASE(unknown_entry_and_subsection)
{
  check_contains(strict_complaint(blank + "subsection Contact\n set Penalty rull = paper\nend\n"),
                 {"cup.prm:5: unknown entry Contact/Penalty rull.", "nearest", "'Penalty rule'"});
  check_contains(strict_complaint(blank + "set Titel = x\n"), {"cup.prm:4: unknown entry Titel.", "'Title'"});
  const auto subsection = strict_complaint(blank + "subsection Contcat\n set Penalty rule = paper\nend\n");
  check_contains(subsection, {"cup.prm:4: unknown subsection Contcat.", "'Contact'"});
  BOOST_TEST(subsection.find("Penalty rule") == std::string::npos); // one complaint for the whole subsection
  check_contains(strict_complaint(blank + "subsection Tools\n subsection pnch\n end\nend\n"),
                 {"cup.prm:5: unknown subsection Tools/pnch.", "'punch'"});
  check_contains(strict_complaint(blank + "subsection Blank\n subsection Inner\n end\nend\n"),
                 {"cup.prm:5: unknown subsection Blank/Inner.", "There is no subsection here."});
}

BOOST_AUTO_TEST_CASE(wrong_section)
{
  check_contains(
    strict_complaint(blank + "subsection Blank\n set Penalty rule = paper\nend\n"),
    {"cup.prm:5: unknown entry Blank/Penalty rule.", "Wrong section? 'Penalty rule' belongs to subsection Contact."});
  check_contains(strict_complaint(blank + "set Motion = t\n"), {"'Motion' belongs to subsection Tools/punch."});
}

BOOST_AUTO_TEST_CASE(unknown_override)
{
  check_contains(strict_complaint(blank, {"Contact/Penalty=1"}), {"--set: unknown entry Contact/Penalty."});
  check_contains(strict_complaint(blank, {"Contakt/Penalty rule=paper"}),
                 {"--set: unknown entry Contakt/Penalty rule", "no subsection 'Contakt'", "'Contact'"});
}

BOOST_AUTO_TEST_CASE(all_complaints_at_once)
{
  const auto message = strict_complaint(blank + "set a = 1\nset b = 2\nsubsection C\nend\n");
  check_contains(message, {"cup.prm:4:", "cup.prm:5:", "cup.prm:6:"});
}

BOOST_AUTO_TEST_CASE(overridden_value_out_of_range_says_so)
{
  auto tree = ParameterTree::parse(blank, "cup.prm", {"Blank/Thickness=-1"});
  check_contains(message_of<SceneError>([&tree]() { declare_everything(tree); }),
                 {"--set: Blank/Thickness = -1: must lie in (0, inf) [length]. Initial thickness."});
}

BOOST_AUTO_TEST_CASE(printed_scene_reads_back)
{
  auto tree = ParameterTree::parse(blank + "set Title = Deep \\\n cup\n", "cup.prm", {"Tools/punch/Motion=0: 0, 1: 2"});
  const auto values = declare_everything(tree);
  BOOST_TEST(values == "Deep cup|0.035|50|adaptive|0.001|1|");
  tree.check_unused();
  std::ostringstream printed;
  tree.print_prm(printed);
  check_contains(printed.str(),
                 {"# [length] (0, inf), required. Initial thickness.\n  set Thickness = 0.07/2\n",
                  "# one of adaptive, paper. Rule.\n  set Penalty rule = adaptive",
                  "    set Motion = 0: 0, 1: 2\n",
                  "    set Note =\n"});
  // In the order of declaration, not of the alphabet.
  BOOST_TEST(printed.str().find("Thickness") < printed.str().find("Elements"));

  auto again = ParameterTree::parse(printed.str(), "again.prm");
  BOOST_TEST(declare_everything(again) == values);
  again.check_unused();
  std::ostringstream printed_again;
  again.print_prm(printed_again);
  BOOST_TEST(printed_again.str() == printed.str());
}

BOOST_AUTO_TEST_CASE(deal_ii_reads_the_printed_scene)
{
  auto tree = ParameterTree::parse(blank, "cup.prm");
  declare_everything(tree);
  std::ostringstream printed;
  tree.print_prm(printed);
  dealii::ParameterHandler handler;
  handler.enter_subsection("Contact");
  handler.declare_entry("Penalty rule", "paper");
  handler.leave_subsection();
  handler.parse_input_from_string(printed.str(), "", true);
  BOOST_TEST(handler.get({"Contact"}, "Penalty rule") == "adaptive");
}

BOOST_AUTO_TEST_CASE(documentation)
{
  auto tree = ParameterTree::documentation();
  BOOST_TEST(declare_everything(tree) == "Cup|0.035|50|adaptive|0.001|0.5|");
  tree.check_unused();
  std::ostringstream page;
  tree.print_markdown(page);
  check_contains(page.str(),
                 {"## Blank\n",
                  "| Thickness | required, e.g. `0.035` | length | (0, inf) | Initial thickness. |",
                  "| Elements | `50` |  | integer in [1, 100000] |",
                  "## Outermost level",
                  "this is \\| shown",
                  "## Tools/punch\n"});
}

BOOST_AUTO_TEST_CASE(authors_are_told_of_their_errors)
{
  auto tree = ParameterTree::documentation();
  Section root = tree.root();
  root.number("x", 1., Range::positive(), "length", "X.");
  BOOST_CHECK_THROW(root.number("x", 2., Range::positive(), "length", "X."), dealii::ExceptionBase);
  BOOST_CHECK_THROW(root.number("x", 1., Range::any(), "length", "X."), dealii::ExceptionBase);
  BOOST_CHECK_THROW(root.number("y", -1., Range::positive(), "length", "Y."), dealii::ExceptionBase);
  BOOST_CHECK_THROW(root.number("a/b", 1., Range::positive(), "length", "Z."), dealii::ExceptionBase);
}

BOOST_AUTO_TEST_CASE(old_names)
{
  const auto value = [](const std::string &text, const std::vector<std::string> &sets) {
    auto tree = ParameterTree::parse(text, "test.prm", sets);
    Section tool = tree.root().sub("Tools").sub("punch");
    std::string result = tool.choice("Thickness compliance", "on", {"on", "off"}, "");
    tree.check_unused();
    return result;
  };
  const std::string open = "subsection Tools\n subsection punch\n", close = " end\nend\n";
  BOOST_TEST(value(open + "set Squeeze = off\n" + close, {}) == "off");
  BOOST_TEST(value("", {"Tools/punch/Squeeze=off"}) == "off");
  BOOST_TEST(value(open + "set Thickness compliance = on\n" + close, {"Tools/punch/Squeeze=off"}) == "off");
  BOOST_CHECK_THROW(value(open + "set Thickness compliance = on\n set Squeeze = off\n" + close, {}), SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
