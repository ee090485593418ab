#include <deltaform/results/earlier_run.h>

#include "../messages.h"

#include <filesystem>
#include <fstream>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(earlier_run)

BOOST_AUTO_TEST_CASE(only_what_the_program_has_written_goes)
{
  const TemporaryFolder folder;
  const auto write = [&](const std::string &name, const std::string &content) {
    std::ofstream(folder.file(name)) << content;
  };
  const std::string head = "# a title\n# deltaform 0.1.0, units: mm\n# units: mm\nR0\n0\n";
  for (const auto *const name : {"profile_1.csv", "contact_0.6.csv", "tools_40_release.csv"})
    write(name, head);
  write("scene.pvd",
        "<?xml version=\"1.0\"?>\n<DataSet timestep=\"0\" part=\"0\" file=\"blank_0000.vtu\"/>\n"
        "<DataSet timestep=\"0\" part=\"1\" file=\"tools_0000.vtu\"/>\n"
        "<DataSet timestep=\"0\" part=\"2\" name=\"die 2\" file=\"tools_0000_1.vtu\"/>\n"
        "<DataSet timestep=\"1\" part=\"0\" file=\"../blank_0001.vtu\"/>\n");
  for (const auto *const name : {"blank_0000.vtu", "tools_0000.vtu", "tools_0000_1.vtu"})
    write(name, "<VTKFile/>");

  const std::vector<const char *> others{"profile_measured.csv", "blank_0007.vtu", "notes.txt", "profile_1.csv.old"};
  for (const auto *const name : others)
    write(name, "r,z\n0,0\n");
  BOOST_TEST(remove_earlier_results(folder.file("")) == 7u);
  unsigned int left = 0;
  for (const auto &entry : std::filesystem::directory_iterator(folder.file("")))
    left += entry.is_regular_file();
  BOOST_TEST(left == others.size());
  for (const auto *const name : others)
    BOOST_TEST(std::filesystem::exists(folder.file(name)));
  BOOST_TEST(remove_earlier_results(folder.file("")) == 0u);
  BOOST_TEST(remove_earlier_results(folder.file("nowhere")) == 0u);
}

BOOST_AUTO_TEST_CASE(drafts_of_a_killed_run_go)
{
  const TemporaryFolder folder;
  for (const auto *const name : {"scene.prm.part", "timing.json.part", "checkpoint.bin.part", "profile_0.5.csv.part",
                                 "blank_0001.vtu.part", "tools_0001_2.vtu.part"})
    folder.file(name, "half");
  for (const auto *const name : {"movie.part", "notes.csv.part", "summary.json", "scene.prm.part.old"})
    folder.file(name, "somebody's");
  BOOST_TEST(remove_drafts(folder.file("")) == 6u);
  for (const auto *const name : {"movie.part", "notes.csv.part", "summary.json", "scene.prm.part.old"})
    BOOST_TEST(std::filesystem::exists(folder.file(name)));
  BOOST_TEST(remove_drafts(folder.file("nowhere")) == 0u);
}

BOOST_AUTO_TEST_CASE(how_an_earlier_run_ended)
{
  const TemporaryFolder folder;
  const auto status_in = [&](const std::string &summary) {
    std::ofstream(folder.file("summary.json")) << summary;
    return earlier_exit_status(folder.path.string());
  };
  BOOST_TEST(!earlier_exit_status(folder.file("")).has_value());
  const std::string in_a_title = "{\"title\": \"\\\"exit_status\\\": 0\",\n\"exit_status\": 2, \"time\": null}";
  BOOST_TEST(status_in(in_a_title).value_or(-1) == 2);
  for (const std::string nothing :
       {"", "[]", "2", "{\"exit_status\": 2", "{\"outcome\": \"done\"}", "{\"exit_status\": null}"})
    BOOST_TEST(!status_in(nothing).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
