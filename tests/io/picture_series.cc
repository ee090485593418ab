#include <deltaform/io/picture_series.h>
#include <deltaform/parameters/scene_error.h>

#include "../messages.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

using namespace deltaform;

namespace
{
  /// Time, part, name and file of every entry of the series on disk.
  std::vector<std::string> entries(const std::string &path)
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(path, tree);
    BOOST_TEST(tree.get<std::string>("VTKFile.<xmlattr>.type") == "Collection");
    std::vector<std::string> result;
    for (const auto &[name, element] : tree.get_child("VTKFile.Collection"))
      if (name == "DataSet")
        result.push_back(element.get<std::string>("<xmlattr>.timestep") + " " +
                         element.get<std::string>("<xmlattr>.part") + " " + element.get<std::string>("<xmlattr>.name") +
                         " " + element.get<std::string>("<xmlattr>.file"));
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(picture_series)

BOOST_AUTO_TEST_CASE(the_file_is_complete_after_each_picture)
{
  const TemporaryFolder folder;
  const auto path = folder.file("scene.pvd");
  PictureSeries series(path);
  std::vector<std::string> expected;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const std::string number = "_000" + std::to_string(i) + ".vtu";
    BOOST_TEST(series.size() == i);
    series.add(.25 * i, {{"blank" + number, "blank"}, {"tools" + number, "die <2> & \"more\""}});
    const std::string time = std::vector<std::string>{"0", "0.25", "0.5"}[i];
    expected.push_back(time + " 0 blank blank" + number);
    expected.push_back(time + " 1 die <2> & \"more\" tools" + number);
    BOOST_TEST(entries(path) == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(times_close_to_each_other_stay_apart)
{
  const TemporaryFolder folder;
  const auto path = folder.file("scene.pvd");
  PictureSeries series(path);
  series.add(1.00000001, {{"a", "x"}});
  series.add(1.00000002, {{"b", "x"}});
  BOOST_TEST(entries(path) == (std::vector<std::string>{"1.00000001 0 x a", "1.00000002 0 x b"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_resumed_series_leaves_out_what_came_later)
{
  const TemporaryFolder folder;
  const auto path = folder.file("scene.pvd");
  {
    PictureSeries series(path);
    for (const double time : {.1, .2, .3})
      series.add(time, {{"blank", "body"}, {"tools", "die"}});
  }
  PictureSeries series(path);
  series.resume(.2);
  BOOST_REQUIRE_EQUAL(series.size(), 2u);
  const auto &last = series.pictures()[1];
  BOOST_TEST(last.time == .2);
  BOOST_REQUIRE_EQUAL(last.parts.size(), 2u);
  BOOST_TEST(last.parts[1].file == "tools");
  BOOST_TEST(last.parts[1].name == "die");
  series.add(.4, {{"new", "body"}});
  BOOST_TEST(entries(path) ==
               (std::vector<std::string>{
                 "0.1 0 body blank", "0.1 1 die tools", "0.2 0 body blank", "0.2 1 die tools", "0.4 0 body new"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_file_is_an_empty_series_and_another_file_is_named)
{
  const TemporaryFolder folder;
  PictureSeries none(folder.file("none.pvd"));
  none.resume(1.);
  BOOST_TEST(none.size() == 0u);
  const auto other = folder.file("other.pvd", "this is no XML");
  check_contains(message_of<SceneError>([&]() { PictureSeries(other).resume(1.); }), {"other.pvd", "resume"});
}

BOOST_AUTO_TEST_SUITE_END()
