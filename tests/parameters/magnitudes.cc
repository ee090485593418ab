#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/magnitudes.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/process/memory.h>

#include "../messages.h"

#include <limits>
#include <stdexcept>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(magnitudes)

BOOST_AUTO_TEST_CASE(products_can_be_computed)
{
  Magnitudes all;
  const auto complaint = [&](const double value, const bool is_size, const char *const unit) {
    return message_of<std::invalid_argument>([&]() { all.add(value, is_size, unit, "Blank/x"); });
  };
  for (const double value : {1e61, -1e160, 1e300, std::numeric_limits<double>::infinity()})
    check_contains(complaint(value, false, "stress"), {"must lie between 1e-60 and 1e60"});
  check_contains(complaint(1e-61, true, "stress"), {"must lie between"});
  BOOST_CHECK_NO_THROW(all.add(1e-300, false, "length", "Blank/round-off"));
  BOOST_CHECK_NO_THROW(all.add(1e59, true, "stress", "Material/x"));
}

BOOST_AUTO_TEST_CASE(lengths_can_be_told_apart)
{
  Magnitudes all;
  const auto complaint = [&](const double value, const bool is_size, const char *const entry) {
    return message_of<std::invalid_argument>([&]() { all.add(value, is_size, "length", entry); });
  };
  all.add(.02, true, "length", "Blank/Thickness");
  all.add(-3e9, false, "length", "Blank/Points");
  check_contains(complaint(1e11, false, "Tools/a/Radius"), {"1e12 times larger than Blank/Thickness = 0.02"});
  check_contains(complaint(1e-4, true, "Tools/b/Radius"), {"1e12 times smaller than Blank/Points"});
  // What was refused is not remembered; a coordinate may be as small as it likes.
  BOOST_CHECK_NO_THROW(all.add(.01, true, "length", "Tools/c/Radius"));
  BOOST_CHECK_NO_THROW(all.add(1e-18, false, "length", "Tools/c/Position z"));
}

BOOST_AUTO_TEST_CASE(an_entry_is_named)
{
  auto tree = ParameterTree::parse("set Thickness = .02\nset Points = 0 0; \\\n 1e160 0\nset Radius = 1e-13\n",
                                   "a.prm");
  Section root = tree.root();
  root.number("Thickness", required(1.), Range::positive(), "length", "");
  check_contains(message_of<SceneError>([&]() { root.rows("Points", "0 0", 2, "length", ""); }),
                 {"a.prm:2: Points = 0 0;", "1e160", "must lie between"});
  root.rows("Corners", "0 0; 1 0", 2, "length", "");
  check_contains(message_of<SceneError>([&]() { root.number("Radius", 1., Range::positive(), "length", ""); }) + "!",
                 {"a.prm:4: Radius = 1e-13"});
}

BOOST_AUTO_TEST_CASE(names_are_parts_of_file_names)
{
  for (const std::string name : {"a/b", "..", "a\x07"})
  {
    auto tree = ParameterTree::parse("", "a.prm", {"Names=form, " + name});
    check_contains(message_of<SceneError>([&]() { tree.root().section_names("Names", "", ""); }),
                   {"--set: Names", "cannot be a name"});
  }
  auto tree = ParameterTree::parse("", "a.prm", {"Names=" + std::string(101, 'a')});
  check_contains(message_of<SceneError>([&]() { tree.root().section_names("Names", "", ""); }), {"at most 100 bytes"});
}

BOOST_AUTO_TEST_CASE(memory_is_asked_for_before_it_is_taken)
{
  auto tree = ParameterTree::parse("set Elements = 1000000000000000\n", "a.prm");
  Section root = tree.root();
  root.number("Elements", 1., Range::positive(), "1", "");
  BOOST_TEST(memory::available() > 1e6);
  BOOST_CHECK_NO_THROW(memory::require(root, "Elements", 1e6, "elements", 10.));
  check_contains(message_of<SceneError>([&]() { memory::require(root, "Elements", 1e15, "elements", 1000.); }),
                 {"a.prm:1: Elements", "1e15 elements need about 1e9 GB", "GB are free"});
}

BOOST_AUTO_TEST_SUITE_END()
