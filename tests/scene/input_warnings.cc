#include <deltaform/checks/rigid_motions.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/scene/input_warnings.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  using Entries = std::vector<std::string>;

  Entries operator+(Entries a, const Entries &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// A strip between a punch in its middle plane and a die beside it, in plane strain; then free.
  const Entries strip{"Blank/Symmetry=plane strain",
                      "Blank/Points=0 0; 40 0",
                      "Blank/Thickness=2",
                      "Blank/Elements=40",
                      "Material/Young's modulus=206e3",
                      "Material/Poisson's ratio=.3",
                      "Material/Hardening/Law=perfectly plastic",
                      "Material/Hardening/Flow stress=200",
                      "Tools/Names=punch, die",
                      "Tools/punch/Shape=circle",
                      "Tools/punch/Radius=3",
                      "Tools/punch/Side=top",
                      "Tools/punch/Position z=4",
                      "Tools/punch/Motion=t",
                      "Tools/punch/Stages=bend",
                      "Tools/die/Shape=die",
                      "Tools/die/Throat radius=25",
                      "Tools/die/Profile radius=3",
                      "Tools/die/Side=bottom",
                      "Tools/die/Position z=-1",
                      "Tools/die/Stages=bend",
                      "Steps/Stages=bend, release"};

  const Entries symmetry{"Supports/Names=symmetry r, symmetry rotation",
                         "Supports/symmetry r/Boundary=start",
                         "Supports/symmetry r/Component=r",
                         "Supports/symmetry rotation/Boundary=start",
                         "Supports/symmetry rotation/Component=rotation"};

  const Entries bottom{"Supports/Names=symmetry r, symmetry rotation, floor",
                       "Supports/floor/Boundary=start",
                       "Supports/floor/Component=z",
                       "Supports/floor/Hold=true",
                       "Supports/floor/Stages=release"};

  std::vector<std::string> warnings(const Entries &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    return input_warnings(Scene(tree));
  }

  std::vector<std::string> motions(const Entries &entries, const unsigned int stage)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    const Scene scene(tree);
    return free_rigid_motions(scene.actors, scene.actors.stages[stage]);
  }

  bool one_has(const std::vector<std::string> &texts, const std::string &part)
  {
    return texts.size() == 1 && texts.front().find(part) != std::string::npos;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(input_warnings)

BOOST_AUTO_TEST_CASE(a_strip_without_supports_slides)
{
  // Punch and die are pressed vertically: two places, so that it does not turn. Nothing but friction holds it along x.
  BOOST_TEST(motions(strip, 0) == Entries{"along r"}, boost::test_tools::per_element());
  BOOST_TEST(motions(strip, 1) == (Entries{"along r", "along z", "a rotation"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(symmetry_holds_it_but_for_the_height_when_the_tools_are_gone)
{
  BOOST_TEST(motions(strip + symmetry, 0).empty());
  BOOST_TEST(motions(strip + symmetry, 1) == Entries{"along z"}, boost::test_tools::per_element());
  BOOST_TEST(one_has(warnings(strip + symmetry), "stage 'release'"));
  BOOST_TEST(warnings(strip + symmetry + bottom).empty());
}

BOOST_AUTO_TEST_CASE(a_tool_under_a_force_holds_nothing_along_it)
{
  const Entries pressed{"Tools/punch/Motion=0", "Tools/punch/Force=1"};
  const Entries alone{"Tools/Names=punch", "Steps/Stages=bend"};
  Entries entries;
  for (const auto &entry : strip)
    if (entry.find("Tools/die") != 0 && entry.find("Motion") == std::string::npos &&
        entry.find("Names") == std::string::npos && entry.find("Steps") != 0)
      entries.push_back(entry);
  entries = entries + Entries{"Tools/Names=punch", "Steps/Stages=bend", "Tools/punch/Force=1"} + symmetry;
  BOOST_TEST(motions(entries, 0) == Entries{"along z"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_load_that_follows_a_displacement_holds_it)
{
  const Entries load{"Loads/Names=lift", "Loads/lift/Kind=edge", "Loads/lift/Component=z", "Loads/lift/Value=0",
                     "Loads/lift/Stages=release"};
  BOOST_TEST(motions(strip + symmetry + load, 1) == Entries{"along z"}, boost::test_tools::per_element());
  BOOST_TEST(motions(strip + symmetry + load + Entries{"Loads/lift/Control=displacement"}, 1).empty());
}

BOOST_AUTO_TEST_CASE(doubtful_numbers_are_named)
{
  const Entries sound = strip + symmetry + bottom;
  BOOST_TEST(one_has(warnings(sound + Entries{"Blank/Elements=81"}), "less than a quarter of the thickness 2"));
  BOOST_TEST(warnings(sound + Entries{"Blank/Elements=80"}).empty());
  BOOST_TEST(
    one_has(warnings(sound + Entries{"Material/Hardening/Flow stress=2061"}), "times the initial flow stress"));
  BOOST_TEST(warnings(sound + Entries{"Material/Hardening/Flow stress=2060"}).empty());
  BOOST_TEST(
    one_has(warnings(sound + Entries{"Tools/die/Friction coefficient=1.01"}), "Tools/die/Friction coefficient"));
  BOOST_TEST(warnings(sound + Entries{"Tools/die/Friction coefficient=1"}).empty());
  BOOST_TEST(one_has(warnings(sound + Entries{"Contact/Allowed penetration=.11*thickness"}),
                     "Contact/Allowed penetration = .11*thickness is 0.22, 11 % of the thickness"));
  BOOST_TEST(warnings(sound + Entries{"Contact/Allowed penetration=.1*thickness"}).empty());
  BOOST_TEST(one_has(warnings(sound + Entries{"Units=mm, N, Mpa"}), "'Mpa' is not known; 'MPa' is"));
  BOOST_TEST(warnings(sound + Entries{"Units=mm, N, MPa"}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
