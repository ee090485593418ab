#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/time_function.h>

#include "../messages.h"

#include <cmath>

using namespace deltaform;

namespace
{
  std::string complaint(const std::string &text)
  {
    return message_of<std::invalid_argument>([&text]() { TimeFunction(text, {}); });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(time_function, *boost::unit_test::tolerance(1e-14))

BOOST_AUTO_TEST_CASE(constants_are_folded)
{
  BOOST_TEST(TimeFunction(3.)(7.) == 3.);
  BOOST_TEST(TimeFunction(3.).text() == "3");
  for (const auto *const text : {"1.5", "3/2", "1.5*thickness/0.03", "0: 1.5, 1: 3/2"})
  {
    const TimeFunction function(text, {{"thickness", .03}});
    BOOST_TEST(function.is_constant());
    BOOST_TEST(function(11.) == 1.5);
    BOOST_TEST(function.text() == text);
  }
}

BOOST_AUTO_TEST_CASE(expressions)
{
  const TimeFunction function("2*t^2 + sin(pi*t) + h", {{"h", .5}});
  const TimeFunction copy = function;
  BOOST_TEST(!function.is_constant());
  BOOST_TEST(function(.5) == 2.);
  BOOST_TEST(copy(1.) == 2.5);
  BOOST_TEST(function(0.) == .5);
  const TimeFunction branches("t < 1 ? t : 2 - t", {});
  BOOST_TEST(branches(.25) == .25);
  BOOST_TEST(branches(1.5) == .5);
  BOOST_TEST(TimeFunction("if(t < 1, log(exp(t)), pow(t, 2))", {})(3.) == 9.);
}

BOOST_AUTO_TEST_CASE(tables)
{
  const TimeFunction table("0: 0, 1: 1.2, 3: 2*h - min(0, 1)", {{"h", .1}});
  BOOST_TEST(!table.is_constant());
  BOOST_TEST(table(-1.) == 0.);
  BOOST_TEST(table(0.) == 0.);
  BOOST_TEST(table(.5) == .6);
  BOOST_TEST(table(1.) == 1.2);
  BOOST_TEST(table(2.) == .7);
  BOOST_TEST(table(3.) == .2);
  BOOST_TEST(table(9.) == .2);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_understood)
{
  check_contains(complaint("2*"), {"cannot evaluate '2*'"});
  check_contains(complaint("2*x"), {"cannot evaluate '2*x'", "\"x\"", "known here: t, pi"});
  check_contains(complaint("t**2"), {"cannot evaluate 't**2'", "t^2"});
  check_contains(complaint("0,8"), {"2 numbers", "with a point"});
  check_contains(complaint("20 kN"), {"cannot evaluate '20 kN'", "without a unit"});
  check_contains(complaint(" "), {"missing"});
  check_contains(complaint("1/0"), {"finite"});
  check_contains(complaint("nan"), {"cannot evaluate 'nan'"});
  check_contains(complaint("0: 0, 1: 1, 1: 2"), {"times of the table must increase", "1 follows 1"});
  check_contains(complaint("0: 0, 2: 1, 1: 2"), {"1 follows 2"});
  check_contains(complaint("0: 0, 1"), {"'1'", "time: value"});
  check_contains(complaint("0: 0, 1:"), {"a number is missing"});
  check_contains(complaint("0: 0, 1: t"), {"depends on t"});
  check_contains(complaint("0: 0; 1: 1"), {"separated by commas"});
  check_contains(complaint("0: 0, 1: inf"), {"finite"});
}

BOOST_AUTO_TEST_CASE(numbers_may_be_expressions)
{
  BOOST_TEST(evaluate_number("1e-3") == 1e-3);
  BOOST_TEST(evaluate_number(" -.5 ") == -.5);
  BOOST_TEST(evaluate_number("0.035/2") == .0175);
  BOOST_TEST(evaluate_number("pi/2") == std::acos(0.));
  BOOST_TEST(evaluate_number("2*1.e-1") == .2);
}

BOOST_AUTO_TEST_CASE(inverse_is_the_first_time)
{
  const TimeFunction table("0: 0, 1: 1, 2: 0, 3: 3", {});
  BOOST_TEST(table.inverse(.5, 0., 3.) == .5);
  BOOST_TEST(table.inverse(.5, 1., 3.) == 1.5);
  BOOST_TEST(table.inverse(1., 0., 3.) == 1.);
  BOOST_TEST(table.inverse(2., 0., 3.) == 2. + 2. / 3.);
  BOOST_TEST(table.inverse(3., 0., 3.) == 3.);
  BOOST_TEST(std::isnan(table.inverse(3., 0., 2.9)));
  BOOST_TEST(std::isnan(table.inverse(-1., 0., 3.)));

  const TimeFunction wave("sin(t)", {});
  BOOST_TEST(wave.inverse(.5, 0., 10.) == std::asin(.5));
  BOOST_TEST(wave.inverse(.5, 2., 10.) == std::acos(-1.) - std::asin(.5));
  BOOST_TEST(TimeFunction("3*t", {}).inverse(1.2, 0., .4) == .4); // 3 * .4 is not 1.2

  BOOST_TEST(TimeFunction(2.).inverse(2., 1., 3.) == 1.);
  BOOST_TEST(std::isnan(TimeFunction(2.).inverse(2.1, 1., 3.)));
}

BOOST_AUTO_TEST_SUITE_END()
