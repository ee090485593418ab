// A tool that comes where the blank is, or whose profile is walked the wrong way round.
#include "../scene/scene_text.h"

#include <deltaform/checks/tool_placement.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const std::string solid = "set Kind = solid\n set Elements = 20\n set Elements through thickness = 2\n";

  /// What is wrong with a tool that comes in stage two, at a travel; nothing has moved.
  std::optional<Misplacement>
  find(const std::string &entries, const double travel, const double tolerance, const std::string &blank)
  {
    const ReadScene read(strip(" set Names = late\n" + tool("late", entries + "  set Stages = two\n"), blank));
    const Actors &actors = read.scene->actors;
    return find_misplacement(*actors.blank, *actors.interfaces[0], Vector(actors.blank->n_dofs()), travel, tolerance);
  }

  std::string profile(const std::string &side, const std::string &points, const std::string &z)
  {
    return "  set Shape = profile\n  set Points = " + points + "\n  set Side = " + side + "\n  set Position z = " + z +
           "\n";
  }
} // namespace

BOOST_AUTO_TEST_SUITE(tool_placement)

BOOST_AUTO_TEST_CASE(an_overlap_is_measured_from_the_face)
{
  // A circle of radius 2 whose pole is .3 above the lower face, at x = 4: node 14 of the mid-surface.
  const std::string circle = "  set Shape = circle\n  set Radius = 2\n  set Side = bottom\n  set Position r = 4\n"
                             "  set Position z = -2.5\n";
  const auto wrong = find(circle, .3, .1, "set Elements = 20\nset Contact points = nodes\n");
  BOOST_TEST_REQUIRE(wrong.has_value());
  BOOST_TEST_MESSAGE(wrong->message);
  BOOST_TEST(wrong->entry == "Position z");
  for (const std::string part : {"tool 'late' overlaps the blank", "node 14", "r = 4, z = 0", "lies 0.3"})
    BOOST_TEST(wrong->message.find(part) != std::string::npos, "'" + part + "' is missing");
  BOOST_TEST(!find(circle, .3, .31, "set Elements = 20\nset Contact points = nodes\n").has_value());
  BOOST_TEST(!find(circle, 0., 1e-9, "set Elements = 20\nset Contact points = nodes\n").has_value());
  // The face of a solid is where its nodes are.
  BOOST_TEST(find(circle, .3, .1, solid).has_value());
  BOOST_TEST(!find(circle, 0., 1e-9, solid).has_value());
}

BOOST_AUTO_TEST_CASE(a_profile_walked_backwards)
{
  struct Case
  {
    std::string side, forward, backward, z;
  };
  const std::vector<Case> cases = {
    // a plane, a step with a wall, a wall beside the end of the strip, a plane that is still far away
    {"bottom", "-20 0; 20 0", "20 0; -20 0", "-thickness/2"},
    {"top", "20 0; -20 0", "-20 0; 20 0", "thickness/2"},
    {"bottom", "-20 0; 3 0; 3 -20", "3 -20; 3 0; -20 0", "-thickness/2"},
    {"top", "20 0; -3 0; -3 20", "-3 20; -3 0; 20 0", "thickness/2"},
    {"bottom", "-12 9; -12 -9", "-12 -9; -12 9", "0"},
    {"bottom", "-20 0; 20 0", "20 0; -20 0", "-30"},
  };
  for (const std::string &blank : {std::string("set Elements = 20\nset Contact points = nodes\n"), solid})
    for (const auto &[side, forward, backward, z] : cases)
      BOOST_TEST_CONTEXT(side << " " << backward << " at " << z << ", " << blank)
      {
        BOOST_TEST(!find(profile(side, forward, z), 0., 1e-9, blank).has_value());
        const auto wrong = find(profile(side, backward, z), 0., 1e-9, blank);
        BOOST_TEST_REQUIRE(wrong.has_value());
        BOOST_TEST(wrong->entry == "Points");
        BOOST_TEST(wrong->message.find("walk it with the blank to its left") != std::string::npos);
      }
}

BOOST_AUTO_TEST_CASE(a_profile_at_the_wrong_place_is_not_walked_backwards)
{
  // A whole thickness too high, or half of it: the way round is right.
  for (const std::string &blank : {std::string("set Elements = 20\nset Contact points = nodes\n"), solid})
    for (const std::string z : {"thickness/2", "0"})
    {
      const auto wrong = find(profile("bottom", "-20 0; 20 0", z), 0., 1e-9, blank);
      BOOST_TEST_REQUIRE(wrong.has_value());
      BOOST_TEST(wrong->entry == "Position z");
    }
}

BOOST_AUTO_TEST_CASE(a_profile_of_plane_strain_has_no_mirror_image)
{
  const auto reaches = [](const std::string &symmetry, const std::string &entry) {
    const std::string die =
      "  set Shape = profile\n  set Points = 0 0; 12 0\n  set Side = bottom\n  set Position z = -thickness/2\n" + entry;
    std::string text = strip(" set Names = die\n" + tool("die", die));
    const auto replace = [&](const std::string &was, const std::string &now) {
      text.replace(text.find(was), was.size(), now);
    };
    replace("plane strain", symmetry);
    replace("-10 0; 10 0", "0 0; 10 0");
    const ReadScene read(text);
    return std::isfinite(read.scene->actors.tools[0]->project(Point2(-1., 0.), 0.).distance);
  };
  BOOST_TEST(!reaches("plane strain", ""));
  BOOST_TEST(reaches("axisymmetric", ""));
  BOOST_TEST(reaches("plane strain", "  set Across the axis = true\n"));
  BOOST_TEST(!reaches("axisymmetric", "  set Across the axis = false\n"));
  BOOST_TEST(!reaches("plane strain", "  set Across the axis = auto\n"));
}

BOOST_AUTO_TEST_SUITE_END()
