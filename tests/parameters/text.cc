#include <deltaform/parameters/text.h>

#include "../messages.h"

#include <cmath>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(text)

BOOST_AUTO_TEST_CASE(splitting)
{
  const std::vector<std::string> expected = {"a", "min(1, 2)", ""};
  BOOST_TEST(deltaform::text::split(" a ,min(1, 2), ", ',') == expected, boost::test_tools::per_element());
  BOOST_TEST(deltaform::text::split("  ", ',').empty());
  BOOST_TEST(deltaform::text::join({"a", "b"}, ", ") == "a, b");
}

BOOST_AUTO_TEST_CASE(numbers_are_short_and_exact)
{
  BOOST_TEST(deltaform::text::format(.1) == "0.1");
  BOOST_TEST(deltaform::text::format(1e7) == "1e7");
  BOOST_TEST(deltaform::text::format(-2.5e-12) == "-2.5e-12");
  BOOST_TEST(deltaform::text::format(100000.) == "100000");
  for (const double value : {1. / 3., -2e-300, 0., 6.02e23, 1e16 + 2.})
    BOOST_TEST(std::stod(deltaform::text::format(value)) == value);
}

BOOST_AUTO_TEST_CASE(distances)
{
  BOOST_TEST(deltaform::text::edit_distance("", "abc") == 3u);
  BOOST_TEST(deltaform::text::edit_distance("kitten", "sitting") == 3u);
  BOOST_TEST(deltaform::text::edit_distance("Penalty Rule", "Penalty rule") == 0u);
  BOOST_TEST(deltaform::text::edit_distance("Thikcness", "Thickness") == 1u);
  BOOST_TEST(deltaform::text::nearest("Thiknes", {"Elements", "Thickness"}) == "Thickness");
  BOOST_TEST(deltaform::text::nearest("x", {}) == "");
  BOOST_TEST(deltaform::text::similar("Thicknes", "Thickness"));
  BOOST_TEST(!deltaform::text::similar("Elements", "Thickness"));
}

BOOST_AUTO_TEST_CASE(four_digits_for_messages)
{
  BOOST_TEST(deltaform::text::rounded(.052836932) == "0.05284");
  BOOST_TEST(deltaform::text::rounded(-123456.) == "-123500");
  BOOST_TEST(deltaform::text::rounded(2e-9 / 3) == "6.667e-10");
  BOOST_TEST(deltaform::text::rounded(0.) == "0");
}

BOOST_AUTO_TEST_CASE(quotes_around_a_value)
{
  BOOST_TEST(deltaform::text::unquoted(" '0: 0, 1: 1.2' ") == "0: 0, 1: 1.2");
  BOOST_TEST(deltaform::text::unquoted("\"t\"") == "t");
  BOOST_TEST(deltaform::text::unquoted("''") == "");
  for (const std::string value : {"'0: 0", "0: 0'", "'t\"", "'", ""}) // no pair
    BOOST_TEST(deltaform::text::unquoted(value) == value);
}

BOOST_AUTO_TEST_CASE(what_a_terminal_would_obey_is_escaped)
{
  BOOST_TEST(deltaform::text::printable("a\tb\nc \u00e9 \u4e2d \U0001f600") == "a\tb\nc \u00e9 \u4e2d \U0001f600");
  BOOST_TEST(deltaform::text::printable("\x1b[2J\r\x07\x7f") == "\\x1b[2J\\x0d\\x07\\x7f");
  BOOST_TEST(deltaform::text::printable(std::string("a\0b", 3)) == "a\\x00b");
  // No UTF-8: lone and missing continuations, too long forms, surrogates, beyond the last character, U+009b.
  BOOST_TEST(deltaform::text::printable("\xff\x80 \xc3") == "\\xff\\x80 \\xc3");
  BOOST_TEST(deltaform::text::printable("\xc0\xaf \xe0\x80\xaf") == "\\xc0\\xaf \\xe0\\x80\\xaf");
  BOOST_TEST(deltaform::text::printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  BOOST_TEST(deltaform::text::printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  BOOST_TEST(deltaform::text::printable("\xc2\x9b") == "\\xc2\\x9b");
}

BOOST_AUTO_TEST_SUITE_END()
