#include <deltaform/io/table_file.h>
#include <deltaform/parameters/scene_error.h>

#include "../messages.h"

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(table_file)

BOOST_AUTO_TEST_CASE(names_contain_the_travel)
{
  BOOST_TEST(table_name("profile", .6) == "profile_0.6.csv");
  BOOST_TEST(table_name("contact", 1.) == "contact_1.csv");
  BOOST_TEST(table_name("tools", 1. / 3.) == "tools_0.333333.csv");
  BOOST_TEST(table_name("profile", .1 + .2) == "profile_0.3.csv");
  BOOST_TEST(table_name("profile", -0.) == "profile_0.csv");
}

BOOST_AUTO_TEST_CASE(numbers_with_units)
{
  const TemporaryFolder folder;
  const auto path = folder.file("profile_1.csv", "something older");
  write_table(path,
              {"Cup", "travel: 1"},
              {{"R0", "stress_mid"}, {"length", "stress"}, {{0., 1.}, {.5, -2e-7}}},
              Units("mm, N, MPa"));
  BOOST_TEST(content_of(path) == "# Cup\n# travel: 1\n# units: mm,MPa\nR0,stress_mid\n0,1\n0.5,-2e-07\n");
  BOOST_TEST(!std::filesystem::exists(path + ".part"));
}

BOOST_AUTO_TEST_CASE(words_among_numbers)
{
  const TemporaryFolder folder;
  const auto path = folder.file("contact_1.csv");
  write_table(path,
              {},
              {{"tool"}, {"epsilon", "force/length"}, {"status"}},
              {{std::string("punch"), 2., std::string("stick")}, {std::string("die, left"), 3., std::string("slip")}},
              Units("mm, N, MPa"));
  BOOST_TEST(content_of(path) == "# units: 1,N/mm,1\ntool,epsilon,status\npunch,2,stick\n\"die, left\",3,slip\n");
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_named)
{
  check_contains(message_of<SceneError>([]() { write_table("/nonexistent/a.csv", {}, Table(), Units("")); }),
                 {"/nonexistent/a.csv", "No such file"});
}

BOOST_AUTO_TEST_CASE(units_are_replaced_word_by_word)
{
  const Units units("in, tonf, tonf/in^2");
  BOOST_TEST(units.label() == "in, tonf, tonf/in^2");
  BOOST_TEST(units.of("length") == "in");
  BOOST_TEST(units.of("force*length") == "tonf*in");
  BOOST_TEST(units.of("force/length^2") == "tonf/in^2");
  BOOST_TEST(units.of("stress") == "tonf/in^2");
  BOOST_TEST(units.of("1") == "1");
  BOOST_TEST(units.of("wavelength") == "wavelength");
  BOOST_TEST(Units("force, length, stress").of("force*length") == "length*force");
  BOOST_TEST(Units("SI").of("force/length") == "force/length");
}

BOOST_AUTO_TEST_SUITE_END()
