// One function per command of the command line.
#include <deltaform/analysis/analysis.h>
#include <deltaform/app/explain.h>
#include <deltaform/app/forming_limit_diagram.h>
#include <deltaform/app/new_scene.h>
#include <deltaform/app/run.h>
#include <deltaform/app/scene_svg.h>
#include <deltaform/app/sweep.h>
#include <deltaform/io/atomic_file.h>
#include <deltaform/materials/back_stress.h>
#include <deltaform/materials/forming_limit.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/material_table.h>
#include <deltaform/materials/point_field.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/materials/yield_surface.h>
#include <deltaform/measures/measure.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/ranks.h>
#include <deltaform/reports/damaged_state.h>
#include <deltaform/reports/history_columns.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/results/observers.h>
#include <deltaform/scene/earlier_operation.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/scene.h>
#include <deltaform/solver/linear_method.h>

#include <deal.II/base/config.h>

#include <filesystem>
#include <iostream>

namespace deltaform
{
  namespace
  {
    /// Has the earlier run in @p folder finished what the scene asks for? @throws SceneError if it had stopped, but
    /// after the end of the scene
    bool nothing_to_resume(const std::string &folder, const double saved, const double end, Journal &journal)
    {
      // One process asks for all: the first one removes the file when it goes on.
      constexpr int killed = -1;
      const int status = static_cast<int>(
        ranks::max(ranks::first() ? earlier_exit_status(folder).value_or(killed) : static_cast<double>(killed)));
      const std::string place =
        "time " + text::format(saved) + ", after the end " + text::format(end) + " that the scene asks for (Steps)";
      if (saved > end && status != exit_status::done)
        throw SceneError("Cannot resume: the state saved in " + folder + " is at " + place +
                         (status != killed ? "; the run had stopped there with status " + std::to_string(status) : "") +
                         ". Ask for a later end to go on from there, or start again without --resume.");
      if (saved < end || status != exit_status::done)
        return false;
      journal.note("the run in " + folder + " is finished" + (saved > end ? ", at " + place : "") +
                   ": there is nothing to resume");
      return true;
    }


    /// What the scene says otherwise than the saved one.
    void compare_scenes(const Checkpoint &start, const ParameterTree &tree, OutputSettings &output, Journal &journal)
    {
      for (const auto &change : start.changes(tree))
        journal.note("resumed with a change: " + change);
      // They are sums over all increments.
      if (output.energies && start.value("Output/Energies") == "false")
      {
        output.energies = false;
        journal.note("energies are not known since the start, so that Output/Energies stays false");
      }
    }


    /// What is on disk is touched when the state has been read, not before.
    void resume(Analysis &analysis, const Checkpoint &start, const std::string &folder, Journal &journal)
    {
      try
      {
        analysis.resume(start);
      }
      catch (const SceneError &)
      {
        throw;
      }
      catch (const std::exception &error)
      {
        throw SceneError(damaged_state(folder, error));
      }
      journal.note("resumed after increment " + std::to_string(start.increment) + ", time " + text::format(start.time));
    }


    int compute(Analysis &analysis, Journal &journal)
    {
      try
      {
        return analysis.run();
      }
      catch (const std::exception &error)
      {
        journal.detail(std::string("the run ends: ") + error.what());
        throw;
      }
    }


    int run_scene(const CommandLine &command)
    {
      Timers timers;
      const auto timer_start = timers.section("1 start-up: reading, checking, mesh");
      Journal journal(!ranks::first() ? Journal::Console::silent
                      : command.quiet ? Journal::Console::quiet
                                      : Journal::Console::automatic);
      auto tree = ParameterTree::read(command.scene, command.sets);
      Scene scene(tree);
      for (const auto &note : scene.notes)
        journal.note(note);

      std::string folder = command.output.empty() ? scene.output->folder : command.output;
      if (folder.empty())
        folder = "output/" + std::filesystem::path(command.scene).stem().string();
      ResultsFolder results({folder, scene.title, scene.units, scene.actors.blank->axisymmetric()}, journal, timers,
                            command.force);
      const auto start = command.resume ? Checkpoint::read(folder) : std::nullopt;
      if (start)
        compare_scenes(*start, tree, *scene.output, journal);
      else if (command.resume)
        journal.note("there is no saved state in " + folder + ": starting from the beginning");
      if (start && nothing_to_resume(folder, start->time, scene.actors.stages.back().end, journal))
        return exit_status::done;
      journal.detail("deltaform " DELTAFORM_VERSION ", deal.II " DEAL_II_PACKAGE_VERSION ", scene " + tree.file_name());
      Analysis analysis(scene.actors, scene.analysis_settings(), journal, timers);
      analysis.add(make_folder_observer(results, [&](std::ostream &out) { tree.print_prm(out); }));
      for (auto &observer : make_observers(analysis.model(), *scene.output, results, start ? &*start : nullptr))
        analysis.add(std::move(observer));
      // Of the mesh that the scene states: that of a saved state may be a refined one.
      auto warnings = input_warnings(scene);
      if (start)
        resume(analysis, *start, folder, journal);
      else if (!scene.start_from.empty())
        analysis.start_from(formed_blank(scene));
      if (!scene.start_from.empty())
        warnings = input_warnings(scene);
      timers.add(timer_start, timers.total());
      analysis.warn(warnings);
      return compute(analysis, journal);
    }


    int check_scene(const CommandLine &command)
    {
      auto tree = ParameterTree::read(command.scene, command.sets);
      const Scene scene(tree);
      auto warnings = input_warnings(scene);
      if (const std::string missing = missing_start(scene); !missing.empty())
        warnings.push_back("Start from = " + scene.start_from + ": " + missing);
      if (ranks::mine() > 0)
        return exit_status::done;
      for (const auto &note : scene.notes)
        std::cerr << "note: " << note << '\n';
      for (const auto &warning : warnings)
        std::cerr << "warning: " << text::printable(warning) << '\n';
      if (!command.svg.empty())
        write_file_atomically(command.svg, [&scene](std::ostream &out) { draw_svg(scene, out); });
      std::cout << text::printable(command.scene + " is a valid scene: " + scene.title) << '\n';
      return exit_status::done;
    }


    template <typename Makers>
    void list(const std::string &title)
    {
      std::cout << title << '\n';
      for (const auto &name : Makers::names())
        std::cout << "  " << name << std::string(name.size() < 24 ? 24 - name.size() : 1, ' ')
                  << Makers::sentence(name) << '\n';
      std::cout << '\n';
    }


    /// The metals of the program's table.
    void list_metals()
    {
      const std::string file = MaterialTable::shipped();
      if (file.empty())
        return;
      const MaterialTable table(file);
      std::cout << "Material/Name\n";
      for (const auto &name : table.names())
        std::cout << "  " << name << std::string(name.size() < 24 ? 24 - name.size() : 1, ' ') << table.source(name)
                  << '\n';
      std::cout << '\n';
    }


    int list_everything()
    {
      list<Registry<Blank>>("Blank/Kind");
      list<Registry<Material>>("Material/Model");
      list_metals();
      list<Registry<Hardening>>("Material/Hardening/Law");
      list<Registry<YieldSurface>>("Material/Yield surface/Law");
      list<Registry<BackStress>>("Material/Backstress/Law");
      list<Registry<RateFactor>>("Material/Rate factor/Law");
      list<PointFields>("Limits/Criteria");
      list<FormingLimits>("Limits/forming limit/Curve");
      list<Registry<Shape>>("Tools/<name>/Shape");
      list<Registry<FrictionLaw>>("Tools/<name>/Friction law");
      list<Registry<NormalLaw>>("Contact/Enforcement");
      list<Registry<PenaltyRule>>("Contact/Penalty rule");
      list<Registry<LinearMethod>>("Solver/Linear solver");
      list<LoadRegistry>("Loads/<name>/Kind");
      list<MeasureRegistry>("Output/Measures/<name>/Kind");
      list<StrategyMakers>("Ways to solve an increment");
      list<ConditionMakers>("Conditions that every run is watched for");
      list<ObserverMakers>("Shown and written, besides history.csv");
      return exit_status::done;
    }


    int print_parameters(const CommandLine &command)
    {
      if (command.scene.empty())
      {
        auto tree = ParameterTree::documentation();
        declare_everything(tree);
        tree.print_markdown(std::cout);
        return exit_status::done;
      }
      auto tree = ParameterTree::read(command.scene, command.sets);
      const Scene scene(tree);
      tree.print_prm(std::cout);
      return exit_status::done;
    }
  } // namespace


  int run_command(const CommandLine &command)
  {
    switch (command.command)
    {
    case CommandLine::Command::run:
      interruption::watch();
      return run_scene(command);
    case CommandLine::Command::check:
      return check_scene(command);
    case CommandLine::Command::forming_limit:
      return write_forming_limit(command);
    case CommandLine::Command::list:
      return list_everything();
    case CommandLine::Command::print_parameters:
      return print_parameters(command);
    case CommandLine::Command::print_columns:
      print_columns(std::cout);
      return exit_status::done;
    case CommandLine::Command::version:
      std::cout << "deltaform " << DELTAFORM_VERSION << '\n';
      return exit_status::done;
    case CommandLine::Command::help:
      std::cout << CommandLine::help();
      return exit_status::done;
    case CommandLine::Command::new_scene:
      new_scene(command.words, std::cout);
      return exit_status::done;
    case CommandLine::Command::explain:
      explain(command.words.front(), std::cout);
      return exit_status::done;
    case CommandLine::Command::sweep:
      throw UsageError("a sweep starts its runs itself (--jobs): do not start it by mpirun");
    }
    return exit_status::wrong_usage;
  }
} // namespace deltaform
