// Metals by name, and entries that a later choice leaves without a meaning.
#include <deltaform/materials/material_table.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/scene.h>

#include "../messages.h"

#include <algorithm>

using namespace deltaform;

namespace
{
  using Strings = std::vector<std::string>;

  /// A sheet pulled at its end; @p material and @p head are lines.
  std::string sheet(const std::string &material, const std::string &head = "set Units = mm, N, MPa\n",
                    const std::string &symmetry = "axisymmetric")
  {
    return head + "subsection Blank\n set Symmetry = " + symmetry +
           "\n set Points = 5 0; 40 0\n set Thickness = 1\n set Elements = 20\nend\nsubsection Material\n" + material +
           "end\nsubsection Supports\n set Names = inside, height, slope, outside\n"
           " subsection inside\n  set Boundary = start\n  set Component = r\n end\n"
           " subsection height\n  set Boundary = start\n  set Component = z\n end\n"
           " subsection slope\n  set Boundary = start\n  set Component = rotation\n end\n"
           " subsection outside\n  set Boundary = end\n  set Component = r\n  set Value = t\n end\nend\n"
           "subsection Steps\n set Stages = pull\n subsection pull\n  set End time = 1\n end\nend\n";
  }

  struct Read
  {
    explicit Read(const std::string &text, const Strings &sets = {})
      : tree(ParameterTree::parse(text, "test.prm", sets)), scene(tree)
    {
    }

    std::string value(const std::string &entry) const
    {
      for (const auto &one : tree.values())
        if (to_string(one.path, one.name) == entry)
          return one.text;
      return "none";
    }

    ParameterTree tree;
    Scene scene;
  };

  std::string complaint(const std::string &text, const Strings &sets = {})
  {
    return message_of<SceneError>([&]() { Read(text, sets); });
  }

  bool mentions(const std::string &text, const std::string &words)
  {
    return text.find(words) != std::string::npos;
  }

  const std::string swift = " set Young's modulus = 206e3\n set Poisson's ratio = .3\n subsection Hardening\n"
                            "  set Law = swift\n  set Strength coefficient = 565\n  set Prestrain = .007\n"
                            "  set Hardening exponent = .26\n end\n";
  const Strings linear{"Material/Hardening/Law=linear", "Material/Hardening/Initial flow stress=150",
                       "Material/Hardening/Hardening modulus=900"};
} // namespace

BOOST_AUTO_TEST_SUITE(named_material)

BOOST_AUTO_TEST_CASE(every_metal_makes_a_scene)
{
  for (const auto &name : MaterialTable(MaterialTable::shipped()).names())
    for (const auto *const symmetry : {"axisymmetric", "plane strain"})
    {
      const Read read(sheet(" set Name = " + name + "\n", "set Units = mm, N, MPa\n", symmetry));
      BOOST_TEST(read.scene.notes.empty(), name);
      for (const auto &warning : input_warnings(read.scene))
        BOOST_TEST(!mentions(warning, "modulus"), name);
    }
  // The yield stress that J.W. Yoon et al. give beside their fit.
  BOOST_TEST(Read(sheet(" set Name = AA2090-T3\n")).scene.actors.blank->initial_flow_stress() == 279.6,
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_scene_counts_more)
{
  const Read read(sheet(" set Name = mild steel\n set Young's modulus = 207e3\n subsection Yield surface\n"
                        "  set r-bar = 1.6\n end\n"));
  BOOST_TEST(read.value("Material/Young's modulus") == "207e3");
  BOOST_TEST(read.value("Material/Yield surface/r-bar") == "1.6");
  BOOST_TEST(read.value("Material/Hardening/Strength coefficient") == "565.32");
  BOOST_REQUIRE(read.scene.notes.size() == 1u);
  BOOST_TEST(mentions(read.scene.notes.front(), "Young's modulus, Material/Yield surface/r-bar count"));
  const Read in_psi(sheet(" set Name = mild steel\n", "set Units = in, lbf, psi\n"));
  BOOST_TEST(std::stod(in_psi.value("Material/Young's modulus")) == 29.8778e6, boost::test_tools::tolerance(1e-5));
  // Another law than the table's: its constants are not asked for any more.
  const Read other(sheet(" set Name = mild steel\n"), linear);
  BOOST_TEST(other.value("Material/Hardening/Strength coefficient") == "none");
  BOOST_TEST(other.value("Material/Hardening/Initial flow stress") == "150");
  BOOST_TEST(other.scene.notes.size() == 4u); // three entries are dropped, the law is the scene's own
  BOOST_TEST(mentions(other.scene.notes.back(), "does not go with Material/Hardening/Law = linear"));
}

BOOST_AUTO_TEST_CASE(names_that_cannot_be)
{
  BOOST_TEST(mentions(complaint(sheet(" set Name = milt steel\n")), "the nearest is 'mild steel'"));
  BOOST_TEST(mentions(complaint(sheet(" set Name = mild steel\n", "")), "Units = consistent does not say"));
  BOOST_TEST(mentions(complaint(sheet(" set Table = mine.prm\n" + swift)), "no metal of it is chosen"));
  BOOST_TEST(mentions(complaint(sheet(" set Name = a\n set Table = mine.prm\n")), "mine.prm: cannot be read"));
  BOOST_TEST(mentions(complaint(sheet(swift, "set Units = mm, N, Pa\n")), "of 1000000 Pa"));
}

BOOST_AUTO_TEST_CASE(values_that_cannot_be)
{
  const auto warned = [](const std::string &head, const Strings &sets, const std::string &words) {
    const Read read(sheet(swift, head), sets);
    const auto warnings = input_warnings(read.scene);
    return std::any_of(warnings.begin(), warnings.end(), [&](const auto &text) { return mentions(text, words); });
  };
  BOOST_TEST(!warned("set Units = mm, N, MPa\n", {}, "Units"));
  BOOST_TEST(!warned("", {"Blank/Thickness=1e-4"}, "Units"));
  BOOST_TEST(warned("set Units = m, N, Pa\n", {}, " GPa is that of no metal"));
  BOOST_TEST(warned("set Units = mm, N, MPa\n", {"Material/Young's modulus=206e9"}, " GPa is that of no metal"));
  BOOST_TEST(warned("set Units = mm, N, MPa\n", {"Blank/Thickness=8e-4"}, " mm is none that is formed"));
}

BOOST_AUTO_TEST_CASE(a_choice_replaced_by_another)
{
  const std::string scene = sheet(swift);
  const Read read(scene, linear);
  BOOST_TEST(read.scene.notes.size() == 3u);
  BOOST_TEST(mentions(read.scene.notes.front(), "Material/Hardening/Strength coefficient = 565 (test.prm:"));
  BOOST_TEST(mentions(read.scene.notes.front(), "Material/Hardening/Law = linear (--set)"));
  // A whole section: elastic blanks have no hardening.
  const Read elastic(scene, {"Material/Model=linear elastic"});
  BOOST_TEST(elastic.scene.notes.size() == 4u);
  BOOST_TEST(elastic.value("Material/Hardening/Law") == "none");
  // What is said before the choice is dropped, also by --set; what is said after it is refused.
  const Strings before{"Material/Hardening/Prestrain=.01", linear[0], linear[1], linear[2]};
  BOOST_TEST(Read(scene, before).scene.notes.size() == 3u);
  BOOST_TEST(mentions(complaint(scene, {linear[0], linear[1], linear[2], "Material/Hardening/Prestrain=.01"}),
                      "unknown entry Material/Hardening/Prestrain"));
  // A misspelt entry is none of another law, and a choice that stays is no new one.
  BOOST_TEST(mentions(complaint(sheet(swift + " set Yong's modulus = 1\n"), linear), "unknown entry"));
  BOOST_TEST(mentions(complaint(sheet(swift + " subsection Backstress\n  set C = 1\n end\n"),
                                {"Material/Hardening/Law=swift"}),
                      "unknown entry Material/Backstress/C"));
}

BOOST_AUTO_TEST_SUITE_END()
