#include "scene_text.h"

#include <deltaform/contact/contact_settings.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/scene/contact_edge.h>
#include <deltaform/scene/input_warnings.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const std::string punch = " set Names = punch\n";

  std::string touched_from_above(const std::string &more = "")
  {
    return punch + tool("punch", "  set Shape = plate\n  set Side = top\n  set Position z = thickness/2\n" + more);
  }

  std::string contact(const std::string &entries)
  {
    return "subsection Contact\n" + entries + "end\n";
  }

  /// delta and elastic slip of a scene at t = 0.
  std::array<double, 2> lengths(const std::string &text)
  {
    const ReadScene read(text);
    return {{read.scene->actors.contact->allowed_penetration(0.), read.scene->actors.contact->allowed_slip(0.)}};
  }

  const std::string shell = "set Elements = 20\n", quadratic = "set Elements = 20\n set Degree = 2\n",
                    // Cells of 20/40 by 1/4.
    solid = "set Kind = solid\n set Elements = 40\n set Elements through thickness = 4\n";
  constexpr double round_off = 1e-12;
} // namespace

BOOST_AUTO_TEST_SUITE(contact_edge)

BOOST_AUTO_TEST_CASE(is_the_shortest_way_between_neighbouring_nodes)
{
  for (const auto &[blank, edge] : {std::pair<std::string, double>{shell, 1.},
                                    {quadratic, .5},
                                    {solid, .5},
                                    {solid + " set Degree = 2\n", .25}})
  {
    const ReadScene read(strip(touched_from_above(), blank));
    BOOST_TEST_CONTEXT(blank)
    BOOST_TEST(std::abs(shortest_contact_edge(*read.scene->actors.blank) - edge) < round_off);
  }
}


BOOST_AUTO_TEST_CASE(thickness_and_edge_mean_the_same_for_shells_and_solids)
{
  const std::string both =
    contact(" set Allowed penetration = 1e-3*thickness + 1e-5*edge\n set Allowed elastic slip = 1e-4*edge\n");
  for (const auto &[blank, edge] : {std::pair<std::string, double>{shell, 1.}, {solid, .5}})
  {
    const auto [delta, slip] = lengths(strip(touched_from_above(), blank) + both);
    BOOST_TEST(std::abs(delta - (1e-3 + 1e-5 * edge)) < round_off);
    BOOST_TEST(std::abs(slip - 1e-4 * edge) < round_off);
  }
  // Of a tool as well.
  const ReadScene own(strip(touched_from_above("  set Allowed penetration = 1e-2*edge + 1e-3*thickness\n"), solid));
  BOOST_TEST(std::abs((*own.scene->actors.tools.front()->allowed_penetration())(0.) - 6e-3) < round_off);
}


BOOST_AUTO_TEST_CASE(default_of_a_shell_counts_in_thicknesses_and_of_a_solid_in_edges)
{
  for (const auto &[blank, length] : {std::pair<std::string, double>{shell, 1e-3}, {solid, 5e-4}})
    for (const double value : lengths(strip(touched_from_above(), blank)))
      BOOST_TEST(std::abs(value - length) < round_off);
}


BOOST_AUTO_TEST_CASE(a_fine_delta_is_kept_inside_the_elements_of_a_sheet_that_gives_way_around_an_axis)
{
  const auto touches_inside = [](const bool around_axis, const std::string &delta, const std::string &more = "") {
    std::string text = strip(touched_from_above(more), shell) + contact(" set Allowed penetration = " + delta + "\n");
    const std::string plane = "plane strain\n set Points = -10 0; 10 0";
    if (around_axis)
      text.replace(text.find(plane), plane.size(), "axisymmetric\n set Points = 5 0; 25 0");
    return ReadScene(text).scene->actors.blank->surface().points_per_edge() > 0U;
  };
  const std::string coarse = "1e-4*thickness", fine = ".99e-4*thickness", rigid = "  set Thickness compliance = off\n";
  for (const bool around_axis : {false, true})
  {
    BOOST_TEST(touches_inside(around_axis, coarse));
    BOOST_TEST(touches_inside(around_axis, coarse, rigid));
    BOOST_TEST(touches_inside(around_axis, fine) == around_axis);
    BOOST_TEST(!touches_inside(around_axis, fine, rigid));
  }
}


BOOST_AUTO_TEST_CASE(edge_is_known_in_penetrations_only)
{
  const std::string text = strip(punch + tool("punch", "  set Shape = plate\n  set Side = top\n"
                                                       "  set Position z = thickness/2\n  set Motion = edge*t\n"));
  BOOST_CHECK_EXCEPTION(ReadScene{text}, SceneError, [](const SceneError &error) {
    const std::string what = error.what();
    return what.find("test.prm:") != std::string::npos && what.find("Tools/punch/Motion") != std::string::npos &&
           what.find("edge*t") != std::string::npos;
  });
  const std::string wrong = strip(touched_from_above()) + contact(" set Allowed penetration = 1e-3*edges\n");
  BOOST_CHECK_EXCEPTION(ReadScene{wrong}, SceneError, [](const SceneError &error) {
    const std::string what = error.what();
    return what.find("test.prm:") != std::string::npos &&
           what.find("Allowed penetration = 1e-3*edges") != std::string::npos;
  });
}


BOOST_AUTO_TEST_CASE(a_solid_of_fine_cells_is_warned_of_a_thousandth_of_its_thickness)
{
  const auto warned = [](const std::string &text) {
    const ReadScene read(text);
    for (const auto &warning : input_warnings(*read.scene))
      if (warning.find("of the shortest contact edge") != std::string::npos)
        return warning;
    return std::string();
  };
  // 1 thick, edges of .01.
  const std::string fine = "set Kind = solid\n set Elements = 2000\n";
  const std::string loose = contact(" set Allowed penetration = 1e-3*thickness\n");
  BOOST_TEST(warned(strip(touched_from_above(), fine) + loose).find("Contact/Allowed penetration = 1e-3*thickness is "
                                                                    "0.001, 10 % of") == 0);
  BOOST_TEST(warned(strip(touched_from_above("  set Allowed penetration = .1*edge\n"), fine))
               .find("Tools/punch/Allowed penetration = .1*edge is") == 0);
  BOOST_TEST(warned(strip(touched_from_above(), fine)) == "");
  BOOST_TEST(warned(strip(touched_from_above(), solid) + loose) == "");
  BOOST_TEST(warned(strip(touched_from_above(), "set Elements = 2000\n") + loose) == "");
  // A constant factor has no delta.
  BOOST_TEST(warned(strip(touched_from_above(), fine) +
                    contact(" set Allowed penetration = 1e-3*thickness\n set Penalty rule = constant\n"
                            " set Penalty factor = 1e5\n")) == "");
}

BOOST_AUTO_TEST_SUITE_END()
