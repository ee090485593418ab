// Warnings before a run with a solid.
#include <deltaform/checks/doubtful_solid.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace deltaform;

namespace
{
  constexpr double endless = std::numeric_limits<double>::infinity();

  std::vector<std::string> findings(const double gap, const double length)
  {
    return doubtful_solid(1.,
                          {{"punch", Side::top, 25., endless, true}, {"die", Side::bottom, 25. + gap, length, false}});
  }
} // namespace

BOOST_AUTO_TEST_SUITE(doubtful_solid)

BOOST_AUTO_TEST_CASE(long_walls_closer_than_the_thickness)
{
  const auto found = findings(.8, endless);
  BOOST_TEST_REQUIRE(found.size() == 1u);
  for (const std::string part : {"'punch'", "'die'", "1 thick", "to 0.8 ", "Shape = profile"})
    BOOST_TEST(found[0].find(part) != std::string::npos, part);
  BOOST_TEST(findings(.8, 5.1).size() == 1u);
  // Plane strain, on the other side of x = 0.
  BOOST_TEST(deltaform::doubtful_solid(
               1., {{"punch", Side::top, -25., endless, false}, {"die", Side::bottom, -25.8, endless, true}})
               .size() == 1u);
}

BOOST_AUTO_TEST_CASE(nothing_to_say)
{
  BOOST_TEST(findings(.8, 4.9).empty()); // a land
  BOOST_TEST(findings(1., endless).empty());
  BOOST_TEST(findings(1.2, endless).empty());
  // Two tools on one side squeeze nothing, nor do two that look the same way (the rims of holder and die).
  BOOST_TEST(deltaform::doubtful_solid(
               1., {{"die", Side::bottom, 25., endless, true}, {"ring", Side::bottom, 25.8, endless, false}})
               .empty());
  BOOST_TEST(deltaform::doubtful_solid(
               1., {{"holder", Side::top, 25., endless, false}, {"die", Side::bottom, 25.8, endless, false}})
               .empty());
  BOOST_TEST(findings(-.8, endless).empty());
}

BOOST_AUTO_TEST_CASE(walls_of_shapes)
{
  const auto walls = [](const std::string &name, const std::string &entries) {
    ParameterTree tree = ParameterTree::parse(entries, "test.prm");
    Section section = tree.root();
    return walls_along_z("tool", Side::bottom, *Registry<Shape>::make(name, section));
  };
  const auto die = walls("die", "set Throat radius = 25.8\n set Profile radius = 6");
  BOOST_TEST_REQUIRE(die.size() == 1u);
  BOOST_TEST(die[0].r == 25.8);
  BOOST_TEST(die[0].length == endless);
  BOOST_TEST(!die[0].outward);
  const auto punch = walls("flat punch", "set Radius = 25\n set Edge radius = 5");
  BOOST_TEST_REQUIRE(punch.size() == 1u);
  BOOST_TEST(punch[0].outward);
  const auto ring =
    walls("profile", "set Points = 26.4 -40; 26.4 -9.6; 25.8 -9; 25.8 0; 80 0\n set Fillet radii = 0, 0, 0, 6, 0");
  BOOST_TEST_REQUIRE(ring.size() == 2u);
  BOOST_TEST(std::abs(ring[0].length - 30.4) < 1e-12);
  BOOST_TEST(std::abs(ring[1].length - 3.) < 1e-12);
  BOOST_TEST(ring[1].r == 25.8);
}

BOOST_AUTO_TEST_SUITE_END()
