#include <deltaform/materials/material_table.h>
#include <deltaform/parameters/scene_error.h>

#include "../messages.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace deltaform;

namespace
{
  std::string value(const std::vector<SceneFile::Entry> &entries, const SectionPath &path, const std::string &name)
  {
    for (const auto &entry : entries)
      if (entry.path == path && entry.name == name)
        return entry.value;
    return "none";
  }

  const SectionPath material{"Material"}, surface{"Material", "Yield surface"}, hardening{"Material", "Hardening"};
} // namespace

BOOST_AUTO_TEST_SUITE(material_table)

BOOST_AUTO_TEST_CASE(every_metal_says_where_it_comes_from)
{
  const MaterialTable table(MaterialTable::shipped());
  const auto names = table.names();
  BOOST_TEST(names.size() >= 10u);
  BOOST_TEST(std::is_sorted(names.begin(), names.end()));
  for (const auto &name : names)
  {
    // An author and a year.
    BOOST_TEST(table.source(name).find_first_of("0123456789") != std::string::npos, name);
    BOOST_TEST(table.source(name).size() > 40u, name);
    BOOST_TEST(value(table.entries(name, 1e6, false), material, "Source") == "none");
  }
}

BOOST_AUTO_TEST_CASE(stresses_in_the_unit_of_the_scene)
{
  const MaterialTable table(MaterialTable::shipped());
  BOOST_TEST(value(table.entries("mild steel", 1e6, false), material, "Young's modulus") == "206000");
  BOOST_TEST(value(table.entries("mild steel", 1., false), hardening, "Strength coefficient") == "5.6532e8");
  BOOST_TEST(value(table.entries("mild steel", 1e9, false), hardening, "Prestrain") == "0.007117");
  const double psi = std::stod(value(table.entries("mild steel", 6894.757, false), material, "Young's modulus"));
  BOOST_TEST(psi == 29.8778e6, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(rolling_direction)
{
  const MaterialTable table(MaterialTable::shipped());
  const auto strip = table.entries("mild steel", 1e6, true), body = table.entries("mild steel", 1e6, false);
  BOOST_TEST(value(strip, surface, "r0") == "1.79");
  BOOST_TEST(value(strip, surface, "r90") == "2.27");
  BOOST_TEST(value(strip, surface, "r45") == "none");
  BOOST_TEST(value(strip, surface, "r-bar") == "none");
  BOOST_TEST(value(body, surface, "r0") == "none");
  const double mean = std::stod(value(body, surface, "r-bar"));
  BOOST_TEST(mean == (1.79 + 2 * 1.51 + 2.27) / 4, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_table_of_the_user)
{
  const auto file = std::filesystem::temp_directory_path() / "deltaform_table_of_the_user.prm";
  std::ofstream(file) << "subsection mine\n set Young's modulus = x MPa\nend\n";
  const MaterialTable table(file.string());
  BOOST_TEST(table.names() == (std::vector<std::string>{"mine"}), boost::test_tools::per_element());
  BOOST_TEST(table.source("mine") == "");
  BOOST_TEST(message_of<SceneError>([&table]() { table.entries("mine", 1e6, false); }).find(":2: Young's modulus") !=
             std::string::npos);
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_SUITE_END()
