#include <deltaform/parameters/variation.h>

#include "../messages.h"

using namespace deltaform;

namespace
{
  using Strings = std::vector<std::string>;

  Strings values(const std::string &text)
  {
    return Variation::read("A/b=" + text, false).values;
  }

  std::string complaint(const std::string &text)
  {
    return message_of<std::invalid_argument>([&text]() { Variation::read(text, true); });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(variation)

BOOST_AUTO_TEST_CASE(values_with_commas_and_semicolons)
{
  const auto each = boost::test_tools::per_element();
  BOOST_TEST(values("1, 2,3") == (Strings{"1", "2", "3"}), each);
  BOOST_TEST(values("0: 0, 1: 1; 0: 0, 1: 2") == (Strings{"0: 0, 1: 1", "0: 0, 1: 2"}), each);
  BOOST_TEST(values("{0 0; 1 1}, {0 0; 1 2; 2 2}") == (Strings{"0 0; 1 1", "0 0; 1 2; 2 2"}), each);
  BOOST_TEST(values("{0: 0, 1: 1}") == (Strings{"0: 0, 1: 1"}), each);
}

BOOST_AUTO_TEST_CASE(intervals)
{
  const auto one = Variation::read("Tools/punch/Radius = .5:2", true);
  BOOST_TEST(one.entry == "Tools/punch/Radius");
  BOOST_TEST(one.interval);
  BOOST_TEST(one.first == .5);
  BOOST_TEST(one.last == 2.);
  BOOST_TEST(one.values.empty());
  // Without samples it is a table of one row; and neither is what is no interval.
  BOOST_TEST(!Variation::read("A/b=.5:2", false).interval);
  for (const auto *const text : {"1,2", "0:1:.5", "0: x", "2:1", "2:2", "0:1,0:2"})
    BOOST_TEST(!Variation::read(std::string("A/b=") + text, true).interval, text);
}

BOOST_AUTO_TEST_CASE(complaints)
{
  for (const auto *const text : {"A/b", "A/b=", "=1", "A/b=1,,2", "A/b={},{1}", "A/b={1}{2}", "A/b={1},2", "A/b={1"})
    BOOST_TEST(complaint(text) != "", text);
}

BOOST_AUTO_TEST_SUITE_END()
