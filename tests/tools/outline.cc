// Outlines of lines and arcs: in the scene, in a file of points, in DXF.
#include <deltaform/geometry/curvature.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>
#include <deltaform/tools/tool_gap.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>
#include <memory>

using namespace deltaform;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  std::unique_ptr<Shape> make(const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root().sub("tool");
    return Registry<Shape>::make("outline", section);
  }

  void write(const std::string &name, const std::string &text)
  {
    std::ofstream(name) << text;
  }

  void refuses(const std::vector<std::string> &entries, const std::string &part)
  {
    BOOST_CHECK_EXCEPTION(make(entries), SceneError, [&](const SceneError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(part) != std::string::npos;
    });
  }

  /// A flat from r = 0 to 10, an edge of radius 4, a wall down to z = -20; in DXF's groups.
  std::string line(const double a, const double b, const double c, const double d)
  {
    return "0\nLINE\n8\n0\n10\n" + std::to_string(a) + "\n20\n" + std::to_string(b) + "\n11\n" + std::to_string(c) +
           "\n21\n" + std::to_string(d) + "\n";
  }

  const std::string head = "0\nSECTION\n2\nENTITIES\n", tail = "0\nENDSEC\n0\nEOF\n";

  void check_flat_edge_wall(const Shape &shape)
  {
    BOOST_TEST(shape.length() == 10. + 2. * pi + 16., boost::test_tools::tolerance(1e-9));
    BOOST_TEST(shape.project({5., 1.5}).distance == 1.5, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(shape.project({16., -10.}).distance == 2., boost::test_tools::tolerance(1e-9));
    const Projection edge = shape.project({10. + 5., -4. + 5.});
    BOOST_TEST(edge.distance == 5. * std::sqrt(2.) - 4., boost::test_tools::tolerance(1e-9));
    BOOST_TEST(edge.normal[0] == std::sqrt(.5), boost::test_tools::tolerance(1e-9));
    BOOST_TEST(smallest_radius(shape) == 4., boost::test_tools::tolerance(1e-9));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(outline)

BOOST_AUTO_TEST_CASE(points_and_arcs_about_a_center)
{
  check_flat_edge_wall(*make({"tool/Path=0 0; 10 0; 14 -4 10 -4 cw; 14 -20"}));
  // The other way round, turned back.
  check_flat_edge_wall(*make({"tool/Path=14 -20; 14 -4; 10 0 10 -4 ccw; 0 0", "tool/Reversed=true"}));
  write("outline_test.txt", "# flat, edge, wall\n0 0\n10, 0\n14 -4 10 -4 cw # the edge\n14 -20\n");
  check_flat_edge_wall(*make({"tool/File=outline_test.txt"}));
}

BOOST_AUTO_TEST_CASE(three_quarters_of_a_circle)
{
  const auto shape = make({"tool/Path=-3 0; 0 0; 5 5 0 5 ccw; 0 10 0 5 ccw; -5 5 0 5 ccw"});
  BOOST_TEST(shape->length() == 3. + 7.5 * pi, boost::test_tools::tolerance(1e-9));
  for (const double angle : {-1.2, 0., 1., 2., 3.})
    BOOST_TEST(shape->project({3. * std::cos(angle), 5. + 3. * std::sin(angle)}).distance == 2.,
               boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(dxf)
{
  // Entities in any order and direction, and one of another kind.
  const std::string point = "0\nPOINT\n8\n0\n10\n3\n20\n3\n";
  write("outline_test.dxf", head + line(0., 0., 10., 0.) + point + line(14., -20., 14., -4.) +
                              "0\nARC\n8\n0\n10\n10\n20\n-4\n40\n4\n50\n0\n51\n90\n" + tail);
  check_flat_edge_wall(*make({"tool/File=outline_test.dxf"}));
  const double bulge = -std::tan(pi / 8.);
  write("outline_test.dxf", head + "0\nLWPOLYLINE\n8\ndie\n90\n4\n70\n0\n10\n0\n20\n0\n10\n10\n20\n0\n42\n" +
                              std::to_string(bulge) + "0\n10\n14\n20\n-4\n10\n14\n20\n-20\n" +
                              line(50., 50., 60., 60.) + tail);
  const auto polyline = make({"tool/File=outline_test.dxf", "tool/Layer=die"});
  // Six digits of the bulge.
  BOOST_TEST(polyline->length() == 10. + 2. * pi + 16., boost::test_tools::tolerance(1e-6));
  refuses({"tool/File=outline_test.dxf"}, "no single path");
  refuses({"tool/File=outline_test.dxf", "tool/Layer=punch"}, "layer 'punch'");
}

BOOST_AUTO_TEST_CASE(what_is_no_outline)
{
  refuses({"tool/File=there_is_none.dxf"}, "cannot be read");
  refuses({"tool/Path=0 0; 1 x"}, "line 2");
  refuses({"tool/Path=0 0; 1 0; 2 -1 5 5 cw"}, "center is not as far");
  refuses({"tool/Path=0 0"}, "fewer than two");
  refuses({}, "give the outline");
  write("outline_test.dxf", "AC1032 binary\nno\n");
  refuses({"tool/File=outline_test.dxf"}, "no ASCII DXF");
}

BOOST_AUTO_TEST_CASE(gap_of_two_tools)
{
  const auto tool = [](const std::string &name, const std::string &side, const std::string &path) {
    ParameterTree tree = ParameterTree::parse("", "test",
                                              {name + "/Shape=outline", name + "/Side=" + side, name + "/Path=" + path,
                                               name + "/Position z=0", name + "/Motion=t"});
    return Tool(name, tree.root().sub(name), {{"thickness", 1.}}, {{"thickness", 1.}});
  };
  // A corner over a flat: 3 above it, and nearer by what it travels down.
  const Tool die = tool("die", "bottom", "0 0; 20 0"), punch = tool("punch", "top", "9 12; 5 3; 1 12");
  BOOST_TEST(tool_gap(punch, 0., die, 0., 50.) == 3., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(tool_gap(die, 0., punch, 0., 50.) == 3., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(tool_gap(punch, 1.25, die, .5, 50.) == 1.25, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
