#include "sweep_table.h"

#include <deltaform/io/csv_reader.h>
#include <deltaform/io/table_file.h>
#include <deltaform/parameters/text.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

namespace deltaform
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    /// The numbers of a column, or nothing.
    using Columns = std::map<std::string, std::vector<double>>;

    /// history.csv by columns; empty if there is none.
    Columns read_history(const std::string &folder)
    {
      Columns result;
      std::ifstream file(folder + "/history.csv");
      CsvReader reader(file);
      const auto &names = reader.names();
      while (const auto cells = reader.next())
        if (cells->size() == names.size())
          for (std::size_t i = 0; i < names.size(); ++i)
            result[names[i]].push_back((*cells)[i].empty() ? nan : std::strtod((*cells)[i].c_str(), nullptr));
      return result;
    }

    double last(const Columns &columns, const std::string &name)
    {
      const auto column = columns.find(name);
      return column == columns.end() ? nan : column->second.back();
    }

    double largest(const Columns &columns, const std::string &name)
    {
      double result = nan;
      const auto column = columns.find(name);
      if (column != columns.end())
        for (const double value : column->second)
          result = std::fmax(result, value); // a number if there is one
      return result;
    }

    boost::property_tree::ptree read_summary(const std::string &folder)
    {
      boost::property_tree::ptree summary;
      try
      {
        boost::property_tree::read_json(folder + "/summary.json", summary);
      }
      catch (const boost::property_tree::json_parser_error &)
      {
        // A run that was killed has none; its row says so.
      }
      return summary;
    }

    /// What became of a run that left no summary: its own words.
    std::string last_words(const SweepRun &run, const double seconds)
    {
      if (run.overdue)
        return "not finished after " + text::format(seconds) + " s";
      if (run.exit_status > 128)
        return "ended by signal " + std::to_string(run.exit_status - 128);
      std::string words;
      std::ifstream console(run.folder + "/console.txt");
      for (std::string line; std::getline(console, line);)
        if (!line.empty())
          words = line;
      return words.empty() ? "no results" : words;
    }

    /// The columns: what is varied, then the results.
    std::vector<CsvWriter::Column> columns_of(const CommandLine &command)
    {
      std::vector<CsvWriter::Column> columns{{"run", "1"}};
      for (const auto &variation : command.variations)
        columns.push_back({variation.entry, "1"});
      columns.insert(columns.end(),
                     {{"exit_status", "1"},
                      {"outcome", "1"},
                      {"time", "time"},
                      {"travel", "length"},
                      {"force_z", "force"},
                      {"max_force", "force"},
                      {"increments", "1"},
                      {"newton_iterations", "1"},
                      {"penalty_rounds", "1"},
                      {"cutbacks", "1"},
                      {"max_penetration", "length"},
                      {"max_penetration_over_delta", "1"},
                      {"max_epsilon", "force/length"},
                      {"max_condition_raw", "1"},
                      {"max_condition_scaled", "1"},
                      {"min_thickness", "length"},
                      {"energy_error", "1"},
                      {"seconds", "s"},
                      {"folder", "1"}});
      return columns;
    }

    /// The row of a run that has ended.
    std::vector<CsvWriter::Cell> row_of(const SweepRun &run, const std::size_t number, const CommandLine &command)
    {
      const Columns history = read_history(run.folder);
      const auto summary = read_summary(run.folder);
      const auto said = [&](const char *const name) { return summary.get<double>(name, nan); };
      // A tool's name may hold the usual separator, a point.
      const boost::property_tree::ptree::path_type max_force("tools/" + run.main_tool + "/max_force", '/');
      std::vector<CsvWriter::Cell> row{static_cast<double>(number)};
      row.insert(row.end(), run.values.begin(), run.values.end());
      const std::vector<CsvWriter::Cell> results{static_cast<double>(run.exit_status),
                                                 summary.empty() ? last_words(run, command.seconds)
                                                                 : summary.get<std::string>("outcome", ""),
                                                 last(history, "time"),
                                                 last(history, run.main_tool + "_travel"),
                                                 last(history, run.main_tool + "_force_z"),
                                                 summary.get<double>(max_force, nan),
                                                 said("increments"),
                                                 said("newton_iterations"),
                                                 said("penalty_rounds"),
                                                 said("cutbacks"),
                                                 largest(history, "max_penetration"),
                                                 said("max_penetration_over_delta"),
                                                 largest(history, "max_epsilon"),
                                                 largest(history, "condition_raw"),
                                                 largest(history, "condition_scaled"),
                                                 said("min_thickness"),
                                                 said("energy_error"),
                                                 said("seconds"),
                                                 std::filesystem::path(run.folder).filename().string()};
      for (const auto &cell : results)
      {
        const auto *const value = std::get_if<double>(&cell);
        row.push_back(value != nullptr && !std::isfinite(*value) ? CsvWriter::Cell(std::string()) : cell);
      }
      return row;
    }
  } // namespace


  void write_sweep_table(const std::string &folder,
                         const CommandLine &command,
                         const std::vector<SweepRun> &runs,
                         const Units &units)
  {
    std::vector<std::vector<CsvWriter::Cell>> rows;
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (runs[i].exit_status >= 0)
        rows.push_back(row_of(runs[i], i + 1, command));
    const std::vector<std::string> comments{"sweep of " + command.scene,
                                            "travel and force are those of the main tool in the last increment; empty: "
                                            "unknown, or not asked for"};
    write_table(folder + "/sweep.csv", comments, columns_of(command), rows, units);
  }
} // namespace deltaform
