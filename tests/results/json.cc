#include <deltaform/results/json.h>

#include "../base/messages.h"

#include <boost/property_tree/json_parser.hpp>

#include <limits>

using namespace deltaform;

namespace
{
  boost::property_tree::ptree parse(const JsonObject &object)
  {
    std::istringstream text(object.to_string());
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(text, tree);
    return tree;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(json)

BOOST_AUTO_TEST_CASE(layout)
{
  JsonObject tool, tools, object;
  tool.add("travel", 1.);
  tools.add("punch", tool);
  object.add("title", "Cup");
  object.add("tools", tools);
  object.add("none", JsonObject());
  object.add("cases", std::vector<JsonObject>{tool, tool});
  object.add("times", std::vector<double>{.1, 2.});
  object.add("stages", std::vector<std::string>{"form", "hold"});
  BOOST_TEST(object.to_string() == R"({
  "title": "Cup",
  "tools": {
    "punch": {
      "travel": 1
    }
  },
  "none": {},
  "cases": [{
    "travel": 1
  }, {
    "travel": 1
  }],
  "times": [0.1, 2],
  "stages": ["form", "hold"]
})");
}

BOOST_AUTO_TEST_CASE(numbers)
{
  JsonObject object;
  object.add("third", 1. / 3.);
  object.add("large", 1e7);
  object.add("nan", std::numeric_limits<double>::quiet_NaN());
  object.add("infinite", -std::numeric_limits<double>::infinity());
  object.add("list", std::vector<double>{1., std::numeric_limits<double>::infinity()});
  object.add("status", 3);
  object.add("count", 4000000000u);
  object.add("kept", true);
  BOOST_TEST(object.to_string() == "{\n  \"third\": 0.3333333333333333,\n  \"large\": 1e7,\n  \"nan\": null,\n"
                                   "  \"infinite\": null,\n  \"list\": [1, null],\n  \"status\": 3,\n"
                                   "  \"count\": 4000000000,\n  \"kept\": true\n}");
  BOOST_TEST(parse(object).get<double>("third") == 1. / 3.);
}

BOOST_AUTO_TEST_CASE(text_is_escaped)
{
  const std::string difficult = "a \"quoted\" \\ back\nslash\tand \x01 control, \xc2\xb5m";
  JsonObject inner, object;
  inner.add(difficult, difficult);
  object.add("inner", inner);
  const auto members = parse(object).get_child("inner");
  BOOST_REQUIRE_EQUAL(members.size(), 1u);
  BOOST_TEST(members.front().first == difficult);
  BOOST_TEST(members.front().second.data() == difficult);
}

BOOST_AUTO_TEST_CASE(a_file_ends_with_a_line_break)
{
  const TemporaryFolder folder;
  const auto path = folder.file("summary.json");
  JsonObject object;
  object.add("done", false);
  write_json(path, object);
  BOOST_TEST(content_of(path) == "{\n  \"done\": false\n}\n");
}

BOOST_AUTO_TEST_SUITE_END()
