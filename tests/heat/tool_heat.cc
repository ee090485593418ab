// What crosses the joint between blank and tool.
#include <deltaform/heat/tool_heat.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

using namespace deltaform;

namespace
{
  ToolHeat read(const std::vector<std::string> &entries)
  {
    MetalHeat metal; // effusivity 12
    metal.capacity = 3.6;
    metal.conductivity = 40.;
    metal.initial_temperature = 800.;
    metal.melting_rise = 700.;
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    ToolHeat result(tree.root(), metal);
    tree.check_unused();
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(tool_heat, *boost::unit_test::tolerance(1e-12))

BOOST_AUTO_TEST_CASE(conductance)
{
  const ToolHeat constant = read({"Conductance=5"});
  BOOST_TEST(constant.conductance(0.) == 5.);
  BOOST_TEST(constant.conductance(1e4) == 5.);
  const ToolHeat rough =
    read({"Conductance=5", "Pressure exponent=.5", "Reference pressure=100", "Largest conductance=20"});
  BOOST_TEST(rough.conductance(100.) == 5.);
  BOOST_TEST(rough.conductance(400.) == 10.);
  BOOST_TEST(rough.conductance(1e6) == 20.);
  BOOST_TEST(rough.conductance(0.) == 0.);
  BOOST_TEST(rough.conductance(-1.) == 0.);
}

BOOST_AUTO_TEST_CASE(temperature)
{
  BOOST_TEST(read({}).rise() == 0.);
  BOOST_TEST(read({"Temperature=20"}).rise() == -780.);
  BOOST_CHECK_THROW(read({"Temperature=1500"}), SceneError);
}

BOOST_AUTO_TEST_CASE(body)
{
  BOOST_TEST(!read({"Effusivity=36"}).effusivity().has_value());
  BOOST_TEST(*read({"Effusivity=36", "Body=half space"}).effusivity() == 36.);
  BOOST_TEST(*read({"Body=half space"}).effusivity() == 12.);
  BOOST_CHECK_THROW(read({"Effusivity=0", "Body=half space"}), SceneError);
  BOOST_CHECK_THROW(read({"Body=wall"}), SceneError);
}

BOOST_AUTO_TEST_CASE(friction_is_split_by_effusivity)
{
  BOOST_TEST(read({}).blank_share() == .5);
  BOOST_TEST(read({"Effusivity=36"}).blank_share() == .25);
  BOOST_TEST(read({"Effusivity=0"}).blank_share() == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
