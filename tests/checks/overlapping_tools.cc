// Tools that run into each other, and that no shipped scene has any.
#include "../scene/scene_text.h"

#include <deltaform/checks/overlapping_tools.h>
#include <deltaform/parameters/scene_error.h>

#include <boost/test/unit_test.hpp>

#include <filesystem>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::vector<std::string> found(const std::string &tools)
  {
    const ReadScene read(strip(tools));
    return deltaform::overlapping_tools(read.scene->actors);
  }

  bool has(const std::string &sentence, const std::string &part)
  {
    return sentence.find(part) != std::string::npos;
  }

  /// A die whose opening is from -3 to 3, and a punch of half width w that goes down by 4 t: its corner meets the
  /// corner of the die when its face has gone by the thickness, at t = .25, if w > 3.
  std::string punch_and_die(const std::string &width, const std::string &drive, const std::string &stages = "")
  {
    return " set Names = punch, die\n" +
           tool("punch",
                "  set Shape = flat punch\n  set Radius = " + width +
                  "\n  set Edge radius = 0\n  set Side = top\n  set Position z = thickness/2\n" + drive + stages) +
           tool("die",
                "  set Shape = die\n  set Throat radius = 3\n  set Profile radius = 0\n  set Side = bottom\n"
                "  set Position z = -thickness/2\n");
  }
} // namespace

BOOST_AUTO_TEST_SUITE(overlapping_tools)

BOOST_AUTO_TEST_CASE(a_punch_wider_than_the_die)
{
  BOOST_TEST(found(punch_and_die("2.9", "  set Motion = 4*t\n")).empty());
  const auto sentences = found(punch_and_die("3.5", "  set Motion = 4*t\n"));
  BOOST_TEST_REQUIRE(sentences.size() == 2u); // in each stage
  BOOST_TEST_MESSAGE(sentences[0]);
  // Stage 'one' is looked at every 1/50: at .26 the face is .04 below the shoulder.
  for (const std::string part : {"'punch' and 'die'", "stage 'one'", "time 0.26 ", "by 0.04", "z = -0.54", "Motion"})
    BOOST_TEST(has(sentences[0], part), "'" + part + "' is missing");
  BOOST_TEST(has(sentences[1], "stage 'two' from time 1 "));
}

BOOST_AUTO_TEST_CASE(who_cannot_clash)
{
  // Not in the same stage, not both moved, or a force finds its own place.
  const auto only_then = found(punch_and_die("3.5", "  set Motion = 4*t\n", "  set Stages = two\n"));
  BOOST_TEST_REQUIRE(only_then.size() == 1u);
  BOOST_TEST(has(only_then[0], "stage 'two'"));
  const ReadScene pressed(strip(punch_and_die("3.5", "  set Force = 4*t\n")));
  BOOST_TEST(deltaform::overlapping_tools(pressed.scene->actors).empty());
  // A stage that ends before.
  std::string text = strip(punch_and_die("3.5", "  set Motion = 4*t\n"));
  text.replace(text.find("set End time = 1\n"), 0, "set Ends when = punch_to_die_gap < 1.01\n  ");
  const auto after = deltaform::overlapping_tools(ReadScene(text).scene->actors);
  BOOST_TEST_REQUIRE(after.size() == 1u);
  BOOST_TEST(has(after[0], "stage 'two'"));
  // Not one that ends where the gap has become large.
  text.replace(text.find("gap < 1.01"), 5, "gap >");
  BOOST_TEST(deltaform::overlapping_tools(ReadScene(text).scene->actors).size() == 2u);
  // Less than a hundredth of the thickness is none.
  BOOST_TEST(found(punch_and_die("3.5", "  set Motion = 1.009*t/2\n")).empty());
  BOOST_TEST(found(punch_and_die("3.5", "  set Motion = 1.011*t/2\n")).size() == 1u);
}

BOOST_AUTO_TEST_CASE(only_near_the_blank)
{
  // Two rings that overlap outside of the strip, which ends at 10.
  const auto rings = [](const std::string &start) {
    return " set Names = upper, lower\n" +
           tool("upper",
                "  set Shape = plate\n  set Inner radius = " + start +
                  "\n  set Side = top\n  set Position z = 1\n  set Motion = 4*t\n") +
           tool("lower", "  set Shape = plate\n  set Side = bottom\n  set Position z = -1\n");
  };
  BOOST_TEST(found(rings("9")).size() == 2u);
  BOOST_TEST(found(rings("12")).empty());
}

BOOST_AUTO_TEST_CASE(no_shipped_scene_has_any)
{
  const std::filesystem::path root = DELTAFORM_SOURCE_DIR;
  unsigned int n_scenes = 0, n_pairs = 0;
  for (const std::string folder : {"prm", "prm/shop", "tests/scenes"})
    for (const auto &file : std::filesystem::directory_iterator(root / folder))
    {
      if (file.path().extension() != ".prm")
        continue;
      ParameterTree tree = ParameterTree::read(file.path().string());
      const Scene scene(tree);
      for (const auto &sentence : deltaform::overlapping_tools(scene.actors))
        BOOST_TEST(false, file.path().string() + ": " + sentence);
      ++n_scenes;
      n_pairs += scene.actors.tools.size() > 1;
    }
  BOOST_TEST(n_scenes > 100u);
  BOOST_TEST(n_pairs > 20u);
}

BOOST_AUTO_TEST_SUITE_END()
