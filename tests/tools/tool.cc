#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/tool.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  Tool make(const std::string &entries, const double thickness = .2)
  {
    ParameterTree tree = ParameterTree::parse(entries, "test.prm");
    Tool tool("punch", tree.root(), {{"thickness", thickness}}, {{"thickness", thickness}});
    tree.check_unused();
    return tool;
  }

  void refuses(const std::string &entries, const std::string &part)
  {
    BOOST_CHECK_EXCEPTION(make(entries),
                          SceneError,
                          [&](const SceneError &error) {
                            BOOST_TEST_MESSAGE(error.what());
                            return std::string(error.what()).find(part) != std::string::npos;
                          });
  }

  const std::string punch = "set Shape = hemispherical punch\n set Radius = 1\n";
} // namespace

BOOST_AUTO_TEST_SUITE(tool)

BOOST_AUTO_TEST_CASE(at_the_bottom)
{
  const Tool tool = make(punch + "set Side = bottom\n set Position z = -thickness/2\n set Motion = 2*t\n");
  BOOST_TEST((tool.side() == Side::bottom));
  BOOST_TEST(tool.direction()[1] == 1.);
  BOOST_TEST(!tool.force_driven());
  BOOST_TEST(tool.travel(.15) == .3);
  BOOST_TEST(tool.allowed_penetration() == nullptr);
  BOOST_TEST(tool.exists_in("form"));
  const Projection p = tool.project({0., .5}, .3); // the pole is at -.1 + .3
  BOOST_TEST(std::abs(p.distance - .3) < 1e-15);
  BOOST_TEST(p.normal[1] == 1.);
  BOOST_TEST(p.tangent[0] == 1.);
  BOOST_TEST(tool.polyline(.3).front().distance(Point2(0., .2)) < 1e-15);
  const auto box = tool.bounding_box(.3);
  BOOST_TEST(box.first[0] == -1.);
  BOOST_TEST(box.second[0] == 1.);
  BOOST_TEST(std::abs(box.second[1] - .2) < 1e-15);
  BOOST_TEST(std::isinf(box.first[1]));
}

BOOST_AUTO_TEST_CASE(on_the_top_it_is_mirrored)
{
  const Tool tool =
    make(punch + "set Side = top\n set Position z = thickness/2\n set Position r = 2\n set Motion = 0: 0, 1: 1.2");
  BOOST_TEST((tool.side() == Side::top));
  BOOST_TEST(tool.direction()[1] == -1.);
  BOOST_TEST(tool.travel(.5) == .6);
  // Center at (2, .1 - .6 + 1); 1.5 from it along (3, -4)/5.
  const Projection p = tool.project({2 + .9, .5 - 1.2}, .6);
  BOOST_TEST(std::abs(p.distance - .5) < 1e-15);
  BOOST_TEST(std::abs(p.normal[0] - .6) < 1e-15);
  BOOST_TEST(std::abs(p.normal[1] + .8) < 1e-15);
  BOOST_TEST(std::abs(p.tangent[0] - .8) < 1e-15);
  BOOST_TEST(std::abs(p.tangent[1] - .6) < 1e-15);
  BOOST_TEST(std::abs(p.arc_length - std::atan2(.6, .8)) < 1e-15);
  const auto box = tool.bounding_box(.6);
  BOOST_TEST(box.first[0] == 1.);
  BOOST_TEST(std::abs(box.first[1] + .5) < 1e-15);
  BOOST_TEST(std::isinf(box.second[1]));
  const auto range = tool.travel_range(.25, .5);
  BOOST_TEST(std::abs(range.first - .3) < 1e-15);
  BOOST_TEST(std::abs(range.second - .6) < 1e-15);
}

BOOST_AUTO_TEST_CASE(derivatives_in_the_scene)
{
  constexpr double h = 1e-6;
  for (const std::string side : {"top", "bottom"})
  {
    const Tool tool = make("set Shape = flat punch\n set Radius = 1\n set Edge radius = .5\n set Side = " + side +
                           "\n set Position z = .1\n set Direction = 3 4\n set Motion = t\n");
    const double mirror = side == "top" ? -1. : 1., travel = .5;
    const Point2 x(.3 + .5 + .3, .5 + mirror * (-.5 + .7)); // off the edge
    const Projection p = tool.project(x, travel);
    BOOST_TEST(p.curvature > 0.);
    BOOST_TEST(p.slip_rate < 1.);
    for (unsigned int d = 0; d < 2; ++d)
    {
      Tensor1 step;
      step[d] = h;
      const Projection a = tool.project(x - step, travel), b = tool.project(x + step, travel);
      BOOST_TEST(std::abs((b.distance - a.distance) / (2 * h) - p.normal[d]) < 1e-9);
      BOOST_TEST(((b.normal - a.normal) / (2 * h) - p.curvature * p.tangent[d] * p.tangent).norm() < 1e-9);
      BOOST_TEST(std::abs((b.arc_length - a.arc_length) / (2 * h) - p.slip_rate * p.tangent[d]) < 1e-9);
    }
    const double rate = (tool.project(x, travel + h).distance - tool.project(x, travel - h).distance) / (2 * h);
    BOOST_TEST(std::abs(rate + p.normal * tool.direction()) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_force_instead_of_a_motion)
{
  const Tool tool = make("set Shape = plate\n set Side = top\n set Position z = thickness/2\n set Force = 2450*t\n"
                         "set Stages = form, hold\n"
                         "set Allowed penetration = 1e-3*thickness*(1+t)");
  BOOST_TEST(tool.force_driven());
  BOOST_TEST(tool.force(.5) == 1225.);
  BOOST_TEST(tool.travel(.5) == 0.);
  BOOST_TEST(std::abs(tool.project({1., 0.}, .01).distance - .09) < 1e-15);
  BOOST_TEST(std::abs((*tool.allowed_penetration())(1.) - 4e-4) < 1e-18);
  BOOST_TEST(tool.exists_in("hold"));
  BOOST_TEST(!tool.exists_in("release"));
}

BOOST_AUTO_TEST_CASE(a_profile_is_not_mirrored)
{
  const Tool tool = make("set Shape = profile\n set Points = 3 1; 0 1\n set Side = top\n set Position z = 0\n"
                         "set Motion = .25");
  const Projection p = tool.project({1., 0.}, tool.travel(0.));
  BOOST_TEST(p.distance == .75);
  BOOST_TEST(p.normal[1] == -1.);
}

BOOST_AUTO_TEST_CASE(wrong_scenes)
{
  const std::string good = punch + "set Side = top\n set Position z = 0\n";
  BOOST_CHECK_NO_THROW(make(good));
  refuses(punch + "set Position z = 0", "Side");
  refuses("set Side = top\n set Position z = 0", "Shape");
  refuses(punch + "set Side = top", "Position z");
  refuses(good + "set Motion = t\n set Force = 1", "not both");
  refuses(good + "set Force = nonsense", "nonsense");
  refuses(good + "set Direction = 0 0", "zero");
  refuses(good + "set Direction = 0 1; 1 0", "two components");
  refuses(good + "set Position r = t", "Motion");
  refuses(good + "set Friction coefficient = -.1", "Friction coefficient");
}

BOOST_AUTO_TEST_SUITE_END()
