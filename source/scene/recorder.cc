#include "recorder_files.h"

#include <deltaform/base/atomic_file.h>
#include <deltaform/base/command_line.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/base/text.h>
#include <deltaform/results/earlier_run.h>
#include <deltaform/results/json.h>

#include <deal.II/base/config.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ostream>

namespace deltaform
{
  namespace
  {
    std::string rounded(const double value, const char *const format = "%.4g")
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, format, value);
      return buffer;
    }
  } // namespace


  Recorder::Recorder(Scene &scene,
                     const std::string &folder,
                     Journal &journal,
                     Timers &timers,
                     const Checkpoint *const start)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw SceneError("Cannot make the folder '" + folder + "' for the results: " + error.message() +
                       ". Choose another with --output or Output/Folder.");
    // State and results of an earlier run must not be taken for those of this run.
    if (!start && ranks::first())
      std::filesystem::remove(Checkpoint::path(folder), error);
    if (ranks::first())
      std::filesystem::remove(folder + "/summary.json", error);
    write_file_atomically(folder + "/scene.prm",
                          [&](std::ostream &out) {
                            out << "# deltaform " << DELTAFORM_VERSION << ", deal.II " << DEAL_II_PACKAGE_VERSION
                                << ": the scene as read, with every default.\n";
                            scene.tree.print_prm(out);
                          });
    journal.open_log(folder + "/run.log", start != nullptr);
    files_ = std::make_unique<Files>(scene, folder, journal, timers, start);
    // Before the first file of the same kind is written.
    if (!start)
      files_->behind.run([folder]() { remove_earlier_results(folder); });
    journal.detail("deltaform " + std::string(DELTAFORM_VERSION) + ", deal.II " + DEAL_II_PACKAGE_VERSION + ", scene " +
                   scene.tree.file_name());
  }


  Recorder::~Recorder() = default;


  void Recorder::begin(const FormingProblem &problem)
  {
    Timers::Scope scope(files_->timers, files_->timer);
    if (!files_->scene.output->frame_times.empty())
      files_->write_picture(problem, files_->scene.actors.stages.front().name, 0.);
  }


  const HistoryRow &Recorder::record(const FormingProblem &problem,
                                     const Stage &stage,
                                     const double time,
                                     const unsigned int increment,
                                     const IncrementCost &cost,
                                     const bool tables)
  {
    Timers::Scope scope(files_->timers, files_->timer);
    files_->last = files_->row(problem, stage, time, increment, cost);
    files_->history->append(files_->last);
    files_->iterations += cost.iterations;
    files_->correction_iterations += cost.correction_iterations;
    if (cost.condition)
      files_->journal.detail(
        "increment " + std::to_string(increment) + ": condition number " + rounded(cost.condition->raw) + ", scaled " +
        rounded(cost.condition->scaled) + "; without contact " + rounded(cost.condition->without_contact) +
        (cost.condition->rigid_modes.empty() ? ", no rigid mode" : " apart from " + cost.condition->rigid_modes));
    files_->rounds += cost.rounds;
    files_->cutbacks += cost.cutbacks;
    files_->worst_promise = std::max(files_->worst_promise, files_->last.max_penetration_over_delta);
    files_->worst_between = std::max(files_->worst_between, files_->last.max_penetration_between_nodes);

    if (files_->journal.wants_progress())
      files_->show_progress(files_->last);
    if (!tables)
      return files_->last;
    const auto &output = *files_->scene.output;
    for (const double asked : output.travel_times)
      if (std::abs(time - asked) <= 1e-9 * std::max(1., std::abs(asked)))
        files_->write_tables(problem, files_->main_travel(problem, time), stage.name);
    bool picture = false;
    while (files_->next_frame < output.frame_times.size() &&
           time >= output.frame_times[files_->next_frame] * (1 - 1e-12))
    {
      picture = true;
      ++files_->next_frame;
    }
    if (picture)
      files_->write_picture(problem, stage.name, time);
    return files_->last;
  }


  void Recorder::Files::show_progress(const HistoryRow &row) const
  {
    const double end = scene.actors.stages.back().end;
    const double spent = timers.total();
    const auto main = scene.output->main_tool;
    std::string line = "increment " + std::to_string(row.increment) + "  " + row.stage + " t = " + rounded(row.time);
    if (main != invalid_index)
      line += "  " + scene.actors.tools[main]->name() + ": travel " + rounded(row.tools[main].travel) + ", force " +
              rounded(row.tools[main].force_z);
    line += "  iterations " + std::to_string(iterations);
    if (scene.actors.contact && scene.actors.contact->enforcement->uses_penalty())
      line += "  p/delta <= " + rounded(worst_promise, "%.3f");
    line += "  left " + rounded(spent * (end - row.time) / std::max(row.time, 1e-300), "%.1f") + " s";
    journal.progress(line);
  }


  void Recorder::finish(const RunOutcome &outcome, const FormingProblem &problem)
  {
    const auto &[exit_status, message, warnings, increments, iterations] = outcome;
    auto &files = *files_;
    {
      Timers::Scope scope(files.timers, files.timer);
      if (exit_status != exit_status::done && increments > 0)
      {
        files.write_tables(problem, files.main_travel(problem, files.last.time), files.last.stage);
        files.write_picture(problem, files.last.stage, files.last.time);
      }
      files.behind.wait();
    }
    JsonObject summary;
    summary.add("title", files.scene.title);
    summary.add("units", files.scene.units);
    summary.add("version", std::string(DELTAFORM_VERSION));
    summary.add("exit_status", exit_status);
    summary.add("outcome",
                std::string(exit_status == exit_status::done            ? "done"
                            : exit_status == exit_status::not_converged ? "not converged"
                                                                        : "promise p <= delta could not be kept"));
    if (!message.empty())
      summary.add("message", message);
    summary.add("warnings", warnings);
    summary.add("unknowns", static_cast<double>(problem.committed().size()));
    summary.add("increments", increments);
    summary.add("newton_iterations", iterations);
    summary.add("penalty_rounds", files.rounds);
    summary.add("penalty_iterations", files.correction_iterations);
    summary.add("cutbacks", files.cutbacks);
    summary.add("time", files.last.time);
    JsonObject tools;
    for (unsigned int i = 0; i < files.last.tools.size(); ++i)
    {
      JsonObject tool;
      tool.add("travel", files.last.tools[i].travel);
      tool.add("force_z", files.last.tools[i].force_z);
      tool.add("force_r", files.last.tools[i].force_r);
      tools.add(files.scene.actors.tools[i]->name(), tool);
    }
    summary.add("tools", tools);
    summary.add("min_thickness", files.last.min_thickness);
    summary.add("max_penetration_over_delta", files.worst_promise);
    summary.add("max_penetration_between_nodes", files.worst_between);
    if (files.scene.output->energies)
      summary.add("energy_error", files.last.energy_error);
    summary.add("seconds", files.timers.total());
    write_file_atomically(files.folder + "/summary.json",
                          [&](std::ostream &out) { out << summary.to_string() << '\n'; });
    write_file_atomically(files.folder + "/timing.json", [&](std::ostream &out) { files.timers.write_json(out); });

    files.journal.finish_progress();
    const auto main = files.scene.output->main_tool;
    std::string line = std::to_string(increments) + " increments, " + std::to_string(iterations) +
                       " Newton iterations, " + rounded(files.timers.total(), "%.2f") + " s";
    if (main != invalid_index && !files.last.tools.empty())
      line = files.scene.actors.tools[main]->name() + ": travel " + rounded(files.last.tools[main].travel) +
             ", force " + rounded(files.last.tools[main].force_z, "%.6g") + "; thinnest " +
             rounded(files.last.min_thickness) + "; " + line;
    if (files.scene.actors.contact && files.scene.actors.contact->enforcement->uses_penalty())
      line += "; max p/delta " + rounded(files.worst_promise, "%.3f");
    files.journal.note(line);
    files.journal.note("results in " + files.folder);
  }
} // namespace deltaform
