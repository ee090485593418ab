#include "sweep_table.h"

#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/child_process.h>
#include <deltaform/process/folder_lock.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/journal.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/scene/scene.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace deltaform
{
  namespace
  {
    /// All combinations; the values of the last variation change fastest.
    std::vector<SweepRun> combinations(const std::vector<CommandLine::Variation> &variations)
    {
      std::vector<SweepRun> runs(1);
      for (const auto &variation : variations)
      {
        std::vector<SweepRun> longer;
        for (const auto &run : runs)
          for (const auto &value : variation.values)
          {
            longer.push_back(run);
            longer.back().values.push_back(value);
          }
        runs = std::move(longer);
      }
      return runs;
    }

    /// The --set of a run: those of the command line, then the varied values.
    std::vector<std::string> assignments(const CommandLine &command, const SweepRun &run)
    {
      std::vector<std::string> result = command.sets;
      for (std::size_t i = 0; i < run.values.size(); ++i)
        result.push_back(command.variations[i].entry + "=" + run.values[i]);
      return result;
    }

    /// In quotes for a shell.
    std::string quoted(const std::string &word)
    {
      std::string result = "'";
      for (const char c : word)
        result += c == '\'' ? "'\\''" : std::string(1, c);
      return result + "'";
    }

    /// The command of a run, for a shell.
    std::string printed(const CommandLine &command)
    {
      std::string result = "deltaform " + quoted(command.scene) + " --quiet --output " + quoted(command.output);
      for (const auto &assignment : command.sets)
        result += " --set " + quoted(assignment);
      return result;
    }

    /// What an earlier sweep has left of a run: its folder holds the scene of @p tree, with every default.
    bool same_scene(const std::string &folder, const ParameterTree &tree)
    {
      std::ifstream file(folder + "/scene.prm");
      std::string version;
      std::getline(file, version);
      std::ostringstream earlier, now;
      earlier << file.rdbuf();
      tree.print_prm(now);
      return file && earlier.str() == now.str();
    }

    /// A run that has ended by itself stays as it is; one that was stopped goes on, if its scene is the same.
    void find_earlier(SweepRun &run, const ParameterTree &tree)
    {
      if (!same_scene(run.folder, tree))
        return;
      const auto status = earlier_exit_status(run.folder);
      if (status && *status <= exit_status::promise_broken)
        run.exit_status = *status;
      else
        run.resume = true;
    }

    /// What the process of a run has to do.
    CommandLine command_of(const CommandLine &command, const SweepRun &run)
    {
      CommandLine result;
      result.scene = command.scene;
      result.sets = assignments(command, run);
      result.output = run.folder;
      result.quiet = true;
      result.resume = run.resume;
      result.force = command.force;
      return result;
    }

    void print_commands(const CommandLine &command, const std::vector<SweepRun> &runs)
    {
      for (const auto &run : runs)
        std::cout << printed(command_of(command, run)) << '\n';
    }

    void make_folder(const std::string &folder)
    {
      std::error_code error;
      std::filesystem::create_directories(folder, error);
      if (error)
        throw SceneError("Cannot make the folder '" + folder + "' for the results: " + error.message() +
                         ". Choose another with --output.");
    }

    /// Of an earlier sweep: it must not be taken for the outcome of this one.
    void remove_outcome(const std::string &folder)
    {
      for (const auto *const name : {"/summary.json", "/history.csv"})
      {
        std::error_code error;
        std::filesystem::remove(folder + name, error);
        if (error)
          throw SceneError("Cannot remove '" + folder + name + "' of an earlier sweep: " + error.message() + ".");
      }
    }

    /// Build the scene of every combination and name the folders. @return the label of the units
    std::string check_all(const CommandLine &command, std::vector<SweepRun> &runs, std::string &folder)
    {
      std::string units;
      for (std::size_t i = 0; i < runs.size(); ++i)
        try
        {
          auto tree = ParameterTree::read(command.scene, assignments(command, runs[i]));
          const Scene scene(tree);
          if (scene.output->main_tool != invalid_index)
            runs[i].main_tool = scene.actors.tools[scene.output->main_tool]->name();
          units = scene.units;
          if (folder.empty())
            folder = !scene.output->folder.empty()
                       ? scene.output->folder
                       : "output/" + std::filesystem::path(command.scene).stem().string() + "_sweep";
          char name[32];
          std::snprintf(name, sizeof name, "/run_%03u", static_cast<unsigned int>(i + 1));
          runs[i].folder = folder + name;
          if (command.resume)
            find_earlier(runs[i], tree);
        }
        catch (const SceneError &error)
        {
          std::string values;
          for (std::size_t k = 0; k < runs[i].values.size(); ++k)
            values += (k > 0 ? ", " : "") + command.variations[k].entry + "=" + runs[i].values[k];
          throw SceneError("The sweep was not started: run " + std::to_string(i + 1) + " of " +
                           std::to_string(runs.size()) + " (" + values + ") is no valid scene. " + error.what());
        }
      return units;
    }

    using Clock = std::chrono::steady_clock;

    /// The runs that have ended.
    struct Ended
    {
      std::size_t n = 0, n_failed = 0;
      int worst = exit_status::done;

      void add(const int status)
      {
        ++n;
        n_failed += status != exit_status::done;
        worst = std::max(worst, status);
      }
    };

    /// A run under way.
    struct Running
    {
      std::size_t run = 0;
      Clock::time_point begin;
    };

    /// End the runs that take longer than they may. @return seconds until the next one does
    double end_overdue(const std::map<int, Running> &running, std::vector<SweepRun> &runs, const double seconds)
    {
      double left = seconds;
      for (const auto &[process, own] : running)
      {
        const double rest = seconds - std::chrono::duration<double>(Clock::now() - own.begin).count();
        runs[own.run].overdue = runs[own.run].overdue || rest <= 0;
        if (rest <= 0)
          end_process(process);
        else
          left = std::min(left, rest);
      }
      return left;
    }
  } // namespace


  int run_sweep(const CommandLine &command, const std::function<int(const CommandLine &)> &run)
  {
    // Checking scenes must not start threads, which would be missing in the copies of this process.
    dealii::MultithreadInfo::set_thread_limit(1);
    auto runs = combinations(command.variations);
    std::string folder = command.output;
    const Units units(check_all(command, runs, folder));
    if (command.print)
    {
      print_commands(command, runs);
      return exit_status::done;
    }
    make_folder(folder);
    const FolderLock lock(folder, command.force);
    interruption::watch();
    Journal journal(command.quiet ? Journal::Console::quiet : Journal::Console::automatic);

    std::map<int, Running> running;
    std::size_t next = 0;
    Ended ended_runs;
    for (const auto &one : runs)
      if (one.exit_status >= 0)
        ended_runs.add(one.exit_status);
    if (ended_runs.n > 0)
      journal.note(std::to_string(ended_runs.n) + " of " + std::to_string(runs.size()) + " runs had ended before");
    if (ended_runs.n == runs.size())
      write_sweep_table(folder, command, runs, units);
    bool interrupted = false;
    while (interrupted ? !running.empty() : ended_runs.n < runs.size())
    {
      if (interruption::signal() != 0 && !interrupted)
      {
        interrupted = true; // those that run save their states; no others are started
        for (const auto &[process, own] : running)
          ask_process_to_end(process);
        continue;
      }
      for (; !interrupted && next < runs.size() && running.size() < command.jobs; ++next)
      {
        if (runs[next].exit_status >= 0)
          continue;
        make_folder(runs[next].folder);
        if (!runs[next].resume)
          remove_outcome(runs[next].folder);
        const auto job = [&run, own = command_of(command, runs[next])]() { return run(own); };
        running[start_process(job, runs[next].folder + "/console.txt")] = {next, Clock::now()};
      }
      constexpr double attention = .2; // seconds within which a signal is heard
      const auto ended = wait_for_process(std::min(attention, end_overdue(running, runs, command.seconds)));
      const auto which = ended ? running.find(ended->process) : running.end();
      if (which == running.end())
        continue;
      SweepRun &own = runs[which->second.run];
      own.exit_status = own.overdue ? exit_status::not_converged : ended->exit_status;
      ended_runs.add(own.exit_status);
      running.erase(which);
      write_sweep_table(folder, command, runs, units);
      journal.progress("sweep: " + std::to_string(ended_runs.n) + " of " + std::to_string(runs.size()) +
                       " runs ended, " + std::to_string(ended_runs.n_failed) + " not done, " +
                       std::to_string(running.size()) + " running");
    }
    journal.finish_progress();
    journal.note(std::to_string(runs.size() - ended_runs.n_failed) + " of " + std::to_string(runs.size()) +
                 " runs done; table in " + folder + "/sweep.csv");
    if (!interrupted)
      return ended_runs.worst;
    journal.note("the sweep was ended by " + interruption::name(interruption::signal()) + "; " +
                 std::to_string(runs.size() - next) + " runs were not started");
    return exit_status::by_signal + interruption::signal();
  }
} // namespace deltaform
