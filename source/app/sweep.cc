#include "sweep_plan.h"
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

    /// What the scenes of a sweep have in common.
    struct Common
    {
      std::string folder, units;
      std::vector<std::string> notes; ///< each once
    };

    /// Build the scene of a run, and look what an earlier sweep has left of it.
    void check_one(const CommandLine &command, SweepRun &run, const std::size_t number, Common &common)
    {
      auto tree = ParameterTree::read(command.scene, assignments(command, run));
      const Scene scene(tree);
      if (scene.output->main_tool != invalid_index)
        run.main_tool = scene.actors.tools[scene.output->main_tool]->name();
      for (const auto &note : scene.notes)
        if (std::find(common.notes.begin(), common.notes.end(), note) == common.notes.end())
          common.notes.push_back(note);
      common.units = scene.units;
      if (common.folder.empty())
        common.folder = !scene.output->folder.empty()
                          ? scene.output->folder
                          : "output/" + std::filesystem::path(command.scene).stem().string() + "_sweep";
      char name[32];
      std::snprintf(name, sizeof name, "/run_%03u", static_cast<unsigned int>(number));
      run.folder = common.folder + name;
      if (command.resume)
        find_earlier(run, tree);
    }

    /// Build the scene of every run and name the folders.
    Common check_all(const CommandLine &command, std::vector<SweepRun> &runs)
    {
      Common common{command.output, "", {}};
      for (std::size_t i = 0; i < runs.size(); ++i)
        try
        {
          check_one(command, runs[i], i + 1, common);
        }
        catch (const SceneError &error)
        {
          std::string values, hint;
          for (std::size_t k = 0; k < runs[i].values.size(); ++k)
          {
            // Of a table '0: 0, 1: 1' only a part is left.
            if (runs[i].values[k].find(':') != std::string::npos)
              hint = " Values that contain commas are separated by semicolons, or stand in braces: {0: 0, 1: 1}.";
            values += (k > 0 ? ", " : "") + command.variations[k].entry + "=" + runs[i].values[k];
          }
          throw SceneError("The sweep was not started: run " + std::to_string(i + 1) + " of " +
                           std::to_string(runs.size()) + " (" + values + ") is no valid scene. " + error.what() + hint);
        }
      return common;
    }


    /// The runs of a sweep while they run: some at a time, the table written whenever one ends.
    class RunningSweep
    {
    public:
      using Run = std::function<int(const CommandLine &)>;

      RunningSweep(const CommandLine &command, std::vector<SweepRun> &runs, const Common &common, const Run &run)
        : command_(command), runs_(runs), folder_(common.folder), units_(common.units), run_(run)
      {
        for (const auto &one : runs_)
          if (one.exit_status >= 0)
            count(one.exit_status);
      }

      std::size_t n_ended() const
      {
        return n_ended_;
      }

      /// Until all have ended, or a signal has come. @return the exit status of the sweep
      int wait(Journal &journal)
      {
        if (n_ended_ == runs_.size())
          write_sweep_table(folder_, command_, runs_, units_);
        bool interrupted = false;
        while (interrupted ? !running_.empty() : n_ended_ < runs_.size())
        {
          if (interruption::signal() != 0 && !interrupted)
          {
            interrupted = true; // those that run save their states; no others are started
            for (const auto &[process, own] : running_)
              ask_process_to_end(process);
            continue;
          }
          if (!interrupted)
            start();
          if (take_ended())
            journal.progress("sweep: " + std::to_string(n_ended_) + " of " + std::to_string(runs_.size()) +
                             " runs ended, " + std::to_string(n_failed_) + " not done, " +
                             std::to_string(running_.size()) + " running");
        }
        journal.finish_progress();
        journal.note(std::to_string(runs_.size() - n_failed_) + " of " + std::to_string(runs_.size()) +
                     " runs done; table in " + folder_ + "/sweep.csv");
        if (!interrupted)
          return worst_;
        journal.note("the sweep was ended by " + interruption::name(interruption::signal()) + "; " +
                     std::to_string(runs_.size() - next_) + " runs were not started");
        return exit_status::by_signal + interruption::signal();
      }

    private:
      using Clock = std::chrono::steady_clock;

      /// A run under way.
      struct Running
      {
        std::size_t run = 0;
        Clock::time_point begin;
      };

      void count(const int status)
      {
        ++n_ended_;
        n_failed_ += status != exit_status::done;
        worst_ = std::max(worst_, status);
      }

      /// As many as may run.
      void start()
      {
        for (; next_ < runs_.size() && running_.size() < command_.jobs; ++next_)
        {
          SweepRun &own = runs_[next_];
          if (own.exit_status >= 0)
            continue;
          make_folder(own.folder);
          if (!own.resume)
            remove_outcome(own.folder);
          const auto job = [this, line = command_of(command_, own)]() { return run_(line); };
          running_[start_process(job, own.folder + "/console.txt")] = {next_, Clock::now()};
        }
      }

      /// End the runs that take longer than they may. @return seconds until the next one does
      double end_overdue()
      {
        double left = command_.seconds;
        for (const auto &[process, own] : running_)
        {
          const double rest = command_.seconds - std::chrono::duration<double>(Clock::now() - own.begin).count();
          runs_[own.run].overdue = runs_[own.run].overdue || rest <= 0;
          if (rest <= 0)
            end_process(process);
          else
            left = std::min(left, rest);
        }
        return left;
      }

      /// Wait a little for a run that ends. @return has one?
      bool take_ended()
      {
        constexpr double attention = .2; // seconds within which a signal is heard
        const auto ended = wait_for_process(std::min(attention, end_overdue()));
        const auto which = ended ? running_.find(ended->process) : running_.end();
        if (which == running_.end())
          return false;
        SweepRun &own = runs_[which->second.run];
        own.exit_status = own.overdue ? exit_status::not_converged : ended->exit_status;
        count(own.exit_status);
        running_.erase(which);
        write_sweep_table(folder_, command_, runs_, units_);
        return true;
      }

      const CommandLine &command_;
      std::vector<SweepRun> &runs_;
      const std::string folder_;
      const Units units_;
      const Run &run_;
      std::map<int, Running> running_; ///< by the numbers of their processes
      std::size_t next_ = 0, n_ended_ = 0, n_failed_ = 0;
      int worst_ = exit_status::done;
    };
  } // namespace


  int run_sweep(const CommandLine &command, const std::function<int(const CommandLine &)> &run)
  {
    // Checking scenes must not start threads, which would be missing in the copies of this process.
    dealii::MultithreadInfo::set_thread_limit(1);
    auto runs = plan_sweep(command);
    const Common common = check_all(command, runs);
    if (command.print)
    {
      print_commands(command, runs);
      return exit_status::done;
    }
    make_folder(common.folder);
    const FolderLock lock(common.folder, command.force);
    interruption::watch();
    Journal journal(command.quiet ? Journal::Console::quiet : Journal::Console::automatic);
    for (const auto &note : common.notes)
      journal.note(note);
    RunningSweep sweep(command, runs, common, run);
    if (sweep.n_ended() > 0)
      journal.note(std::to_string(sweep.n_ended()) + " of " + std::to_string(runs.size()) + " runs had ended before");
    return sweep.wait(journal);
  }
} // namespace deltaform
