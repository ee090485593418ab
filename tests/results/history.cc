#include <deltaform/parameters/scene_error.h>
#include <deltaform/results/history.h>

#include "../messages.h"

#include <filesystem>

using namespace deltaform;

namespace
{
  const std::vector<std::string> comments{"Cup", "deltaform 0.1.0, units: in, tonf, tonf/in^2"};

  std::vector<std::string> lines_of(const std::string &path)
  {
    std::istringstream content(content_of(path));
    std::vector<std::string> result;
    for (std::string line; std::getline(content, line);)
      result.push_back(line);
    return result;
  }

  std::vector<CsvWriter::Column> columns(const std::string &tool)
  {
    return {{"increment", "1"}, {"stage", "1"}, {"time", "time"}, {tool + "_travel", "in"}, {"force", "tonf"}};
  }

  std::vector<CsvWriter::Cell> row(const unsigned int increment)
  {
    return {static_cast<double>(increment), std::string("form, slowly"), increment / 3., 1., 2.};
  }

  void write(const std::string &path, const unsigned int n_rows)
  {
    History history(path, comments, columns("punch"));
    history.open();
    for (unsigned int i = 1; i <= n_rows; ++i)
      history.append(row(i));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(history)

BOOST_AUTO_TEST_CASE(the_head_names_units_and_columns)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  write(path, 0);
  const auto lines = lines_of(path);
  BOOST_REQUIRE_EQUAL(lines.size(), 4u);
  BOOST_TEST(lines[0] == "# Cup");
  BOOST_TEST(lines[1] == "# deltaform 0.1.0, units: in, tonf, tonf/in^2");
  BOOST_TEST(lines[2] == "# units: 1,1,time,in,tonf");
  BOOST_TEST(lines[3] == "increment,stage,time,punch_travel,force");
}

BOOST_AUTO_TEST_CASE(a_row_is_on_disk_when_it_is_known)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  History history(path, comments, columns("punch"));
  BOOST_TEST(!std::filesystem::exists(path));
  history.open();
  history.append(row(1));
  BOOST_TEST(lines_of(path).back() == "1,\"form, slowly\",0.3333333333,1,2");
}

BOOST_AUTO_TEST_CASE(a_resumed_history_goes_on_after_the_increment)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv"), reference = folder.file("reference.csv");
  write(path, 5);
  write(reference, 4);
  {
    const std::string before = content_of(path);
    History history(path, comments, columns("punch"), History::Resumption{3});
    BOOST_TEST(content_of(path) == before);
    history.open();
    history.append(row(4));
  }
  BOOST_TEST(content_of(path) == content_of(reference));
}

BOOST_AUTO_TEST_CASE(a_row_cut_off_by_a_kill_is_dropped)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv"), reference = folder.file("reference.csv");
  write(path, 3);
  write(reference, 2);
  for (const unsigned int cut : {1u, 3u, 20u}) // without its end, within a number, within the row
  {
    write(path, 3);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - cut);
    // A state that counts on the row goes on with it or not at all.
    check_contains(message_of<SceneError>([&]() { History(path, comments, columns("punch"), History::Resumption{3}); }),
                   {"that of increment 3", "ends at increment 2", "were lost"});
    History history(path, comments, columns("punch"), History::Resumption{2});
    history.open();
    BOOST_TEST(content_of(path) == content_of(reference));
  }
}

BOOST_AUTO_TEST_CASE(only_the_same_history_is_resumed)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  write(path, 2);
  const std::string before = content_of(path);
  const auto resume = [&](const std::string &file, const std::string &tool) {
    return message_of<SceneError>([&]() { History(file, comments, columns(tool), History::Resumption{1}); });
  };
  check_contains(resume(path, "die"), {"history.csv", "columns", "'punch_travel' is only in the file"});
  BOOST_TEST(content_of(path) == before);
  check_contains(resume(folder.file("none.csv"), "punch"), {"none.csv", "No such file"});
}

BOOST_AUTO_TEST_CASE(columns_of_before_are_kept)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  write(path, 2);
  // The force is not asked for any more, an energy is asked for only now.
  std::vector<CsvWriter::Column> now = columns("punch");
  now.back() = {"energy", "in*tonf"};
  History history(path, comments, now, History::Resumption{2, {"force", "energy"}});
  BOOST_TEST((history.left_out() == std::vector<std::string>{"energy"}));
  history.open();
  history.append(row(3));
  const auto lines = lines_of(path);
  BOOST_TEST(lines[2] == "# units: 1,1,time,in,tonf");
  BOOST_TEST(lines[3] == "increment,stage,time,punch_travel,force");
  BOOST_TEST(lines[5] == "2,\"form, slowly\",0.6666666667,1,2");
  BOOST_TEST(lines[6] == "3,\"form, slowly\",1,1,");
}

BOOST_AUTO_TEST_SUITE_END()
