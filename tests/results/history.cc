#include <deltaform/base/scene_error.h>
#include <deltaform/results/history.h>

#include "../base/messages.h"

#include <set>

using namespace deltaform;

namespace
{
  const Units units("in, tonf, tonf/in^2");
  const std::vector<std::string> comments{"Cup", "deltaform 0.1.0, units: in, tonf, tonf/in^2"};

  std::vector<std::string> lines_of(const std::string &path)
  {
    std::istringstream content(content_of(path));
    std::vector<std::string> result;
    for (std::string line; std::getline(content, line);)
      result.push_back(line);
    return result;
  }

  HistoryRow row(const unsigned int increment, const unsigned int n_tools)
  {
    HistoryRow row;
    row.increment = increment;
    row.stage = "form, slowly";
    row.time = increment / 3.;
    for (unsigned int i = 0; i < n_tools; ++i)
      row.tools.push_back({1. + i, 2. + i, 3. + i});
    row.newton_iterations = 5;
    row.max_epsilon = 1e7;
    row.energy_error = -1e-5;
    return row;
  }

  void write(const std::string &path, const unsigned int n_rows)
  {
    History history(path, comments, {"punch"}, units);
    for (unsigned int i = 1; i <= n_rows; ++i)
      history.append(row(i, 1));
  }

  HistoryOptions resume_after(const unsigned int increment)
  {
    HistoryOptions options;
    options.resume_after = increment;
    return options;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(history)

BOOST_AUTO_TEST_CASE(columns_have_underscores_for_blanks)
{
  HistoryOptions options;
  options.supports = {"no turn"};
  std::set<std::string> names;
  for (const auto &column : History::columns({"die 2"}, units, options))
    names.insert(column.name);
  for (const auto *const name : {"die_2_travel", "die_2_force_z", "die_2_force_r", "no_turn_reaction"})
    BOOST_TEST(names.count(name) == 1u);
  for (const auto &name : names)
    BOOST_TEST((name.find(' ') == std::string::npos));
}

BOOST_AUTO_TEST_CASE(columns_are_those_of_the_contract)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  const History history(path, comments, {"punch", "die"}, units);
  const auto lines = lines_of(path);
  BOOST_REQUIRE_EQUAL(lines.size(), 4u);
  BOOST_TEST(lines[0] == "# Cup");
  BOOST_TEST(lines[1] == "# deltaform 0.1.0, units: in, tonf, tonf/in^2");
  BOOST_TEST(lines[2] == "# units: 1,1,time,in,tonf,tonf,in,tonf,tonf,1,1,1,1,in,1,in,tonf/in,tonf/in,1,1,in,"
                         "tonf*in,tonf*in,tonf*in,tonf*in,tonf*in,tonf*in,tonf*in,tonf*in,1,1");
  // Part of the interface: add, do not rename.
  BOOST_TEST(lines[3] ==
             "increment,stage,time,punch_travel,punch_force_z,punch_force_r,"
             "die_travel,die_force_z,die_force_r,newton_iterations,penalty_rounds,penalty_iterations,cutbacks,"
             "max_penetration,max_penetration_over_delta,max_penetration_between_nodes,"
             "min_epsilon,max_epsilon,floor_share,contact_pairs,min_thickness,"
             "tool_work,elastic_energy,plastic_energy,friction_energy,contact_energy,"
             "epsilon_work,thickness_work,load_work,energy_error,balance_error");
}

BOOST_AUTO_TEST_CASE(condition_numbers_only_where_asked)
{
  HistoryOptions options;
  options.condition = true;
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  History history(path, {}, {}, units, options);
  HistoryRow one = row(1, 0);
  one.condition_scaled = 12.5;
  history.append(one);
  const auto lines = lines_of(path);
  check_contains(lines[1],
                 {",min_thickness,condition_raw,condition_scaled,condition_without_contact,rigid_modes,digits_lost,"
                  "tool_work,"});
  check_contains(lines[2], {",0,nan,12.5,nan,0,nan,0,"});
}

BOOST_AUTO_TEST_CASE(a_row_is_on_disk_when_it_is_known)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv");
  History history(path, comments, {"punch"}, units);
  HistoryRow one = row(1, 1);
  one.penalty_rounds = 6;
  one.penalty_iterations = 65;
  one.cutbacks = 7;
  one.max_penetration = 8;
  one.max_penetration_over_delta = 9;
  one.max_penetration_between_nodes = 10;
  one.min_epsilon = 11;
  one.max_epsilon = 12;
  one.floor_share = 13;
  one.contact_pairs = 14;
  one.min_thickness = 15;
  one.tool_work = 16;
  one.elastic_energy = 17;
  one.plastic_energy = 18;
  one.friction_energy = 19;
  one.contact_energy = 20;
  one.epsilon_work = 21;
  one.thickness_work = 22;
  one.load_work = 23;
  one.energy_error = 24;
  one.balance_error = 25;
  history.append(one);
  BOOST_TEST(lines_of(path).back() ==
             "1,\"form, slowly\",0.3333333333,1,2,3,5,6,65,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25");
}

BOOST_AUTO_TEST_CASE(a_resumed_history_goes_on_after_the_increment)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv"), reference = folder.file("reference.csv");
  write(path, 5);
  write(reference, 4);
  {
    History history(path, comments, {"punch"}, units, resume_after(3));
    history.append(row(4, 1));
  }
  BOOST_TEST(content_of(path) == content_of(reference));
}

BOOST_AUTO_TEST_CASE(a_row_cut_off_by_a_kill_is_dropped)
{
  const TemporaryFolder folder;
  const auto path = folder.file("history.csv"), reference = folder.file("reference.csv");
  write(path, 3);
  write(reference, 2);
  for (const unsigned int cut : {1u, 3u, 30u}) // without its end, within a number, within the row
  {
    write(path, 3);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - cut);
    {
      const History history(path, comments, {"punch"}, units, resume_after(3));
    }
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
    return message_of<SceneError>([&]() { History(file, comments, {tool}, units, resume_after(1)); });
  };
  check_contains(resume(path, "die"), {"history.csv", "columns"});
  BOOST_TEST(content_of(path) == before);
  check_contains(resume(folder.file("none.csv"), "punch"), {"none.csv", "No such file"});
}

BOOST_AUTO_TEST_SUITE_END()
