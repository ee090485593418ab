// Runs a scene and holds its results against what its comments expect (directives.h).
//
//   compare_scene DELTAFORM SCENE WORK
//
// WORK is emptied first. Exit status: 0 all as expected, 1 something is not, 2 the test itself is wrong.
#include "csv_table.h"
#include "directives.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{
  namespace fs = std::filesystem;

  unsigned int n_checks = 0, n_failed = 0;


  void report(const bool good, const std::string &what)
  {
    ++n_checks;
    n_failed += !good;
    std::cout << (good ? "  ok      " : "  FAILED  ") << what << '\n';
  }


  std::string shown(const double value, const char *const format = "%.9g")
  {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
  }


  double selected(const CsvTable &table, const Check &check)
  {
    const auto &values = table.column(check.column);
    if (check.select.substr(0, 3) == "max" || check.select == "min")
      for (const double value : values)
        if (std::isnan(value))
          return value;
    if (check.select == "first")
      return values.front();
    if (check.select == "last")
      return values.back();
    if (check.select == "max")
      return *std::max_element(values.begin(), values.end());
    if (check.select == "min")
      return *std::min_element(values.begin(), values.end());
    if (check.select == "maxabs")
      return std::abs(*std::max_element(
        values.begin(), values.end(), [](const double a, const double b) { return std::abs(a) < std::abs(b); }));
    return interpolate(table.column(check.at_column), values, check.at);
  }


  void evaluate(const Check &check, const fs::path &work)
  {
    const double value = selected(CsvTable::read((work / check.file).string()), check);
    if (check.kind != Check::Kind::within)
    {
      const bool below = check.kind == Check::Kind::below;
      report(below ? value < check.reference : value > check.reference,
             check.text + ": " + shown(value) + (below ? ", below " : ", above ") + shown(check.reference));
      return;
    }
    const double error = std::abs(value - check.reference) / (check.relative ? std::abs(check.reference) : 1.);
    report(error <= check.tolerance,
           check.text + ": " + shown(value) + ", reference " + shown(check.reference) + ", error " +
             shown(error, "%.2e") + (check.relative ? " relative" : "") + ", allowed " +
             shown(check.tolerance, "%.2e"));
  }


  void evaluate(const Comparison &comparison, const fs::path &work, const fs::path &references)
  {
    const auto table = CsvTable::read((work / comparison.file).string());
    const auto reference = CsvTable::read((references / comparison.reference).string());
    for (const auto &name : comparison.columns)
    {
      const auto &expected = reference.column(name);
      const auto &found = table.column(name);
      const double largest = std::abs(*std::max_element(
        expected.begin(), expected.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
      double error = 0.;
      std::size_t worst = 0;
      if (comparison.over.empty() && expected.size() != found.size())
        throw std::runtime_error(comparison.file + " has " + std::to_string(found.size()) + " rows, the reference " +
                                 std::to_string(expected.size()));
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        const double value =
          comparison.over.empty()
            ? found[i]
            : interpolate(table.column(comparison.over), found, reference.column(comparison.over)[i]);
        double now = std::abs(value - expected[i]) / (comparison.relative && largest > 0 ? largest : 1.);
        if (std::isnan(now))
          now = std::numeric_limits<double>::infinity();
        if (now > error)
        {
          error = now;
          worst = i;
        }
      }
      report(error <= comparison.tolerance,
             comparison.file + " " + name + " as in " + comparison.reference + ": largest error " +
               shown(error, "%.2e") + (comparison.relative ? " of the largest value" : "") + " in row " +
               std::to_string(worst + 1) + ", allowed " + shown(comparison.tolerance, "%.2e"));
    }
  }


  std::string content(const fs::path &file)
  {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  }


  void run(const fs::path &program, const fs::path &scene, const fs::path &work)
  {
    const auto expected = Directives::read(scene.string(), work.string());
    fs::remove_all(work);
    fs::create_directories(work);
    const fs::path log = work / "console.txt";
    const std::string call = "'" + program.string() + "' " + expected.command + " >'" + log.string() + "' 2>&1";
    const int result = std::system(call.c_str()); // NOLINT: the commands are those of the test scenes
    const std::string said = content(log);
    std::cout << scene.filename().string() << ": deltaform " << expected.command << '\n';

    const int status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
    report(status == expected.exit_status,
           "exit status " + std::to_string(status) + ", expected " + std::to_string(expected.exit_status));
    for (const auto &message : expected.messages)
      report(said.find(message) != std::string::npos, "message has '" + message + "'");
    if (n_failed > 0 || !expected.messages.empty())
      std::cout << "  it says: " << said << (said.empty() || said.back() != '\n' ? "\n" : "");
    for (const auto &file : expected.files)
      report(!CsvTable::read((work / file).string()).columns.empty(), file + " can be read");
    for (const auto &check : expected.checks)
      evaluate(check, work);
    for (const auto &comparison : expected.comparisons)
      evaluate(comparison, work, scene.parent_path() / "reference");
  }
} // namespace


int
main(int argc, char *argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: compare_scene DELTAFORM SCENE WORK\n";
    return 2;
  }
  try
  {
    run(fs::absolute(argv[1]), fs::absolute(argv[2]), fs::absolute(argv[3]));
  }
  catch (const std::exception &error)
  {
    report(false, error.what());
    std::cout << "  cannot go on\n";
    return 2;
  }
  std::cout << (n_failed == 0 ? "all " + std::to_string(n_checks) + " checks passed\n"
                              : std::to_string(n_failed) + " of " + std::to_string(n_checks) + " checks failed\n");
  return n_failed == 0 ? 0 : 1;
}
