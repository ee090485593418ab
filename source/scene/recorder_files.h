#pragma once
// The open files of a recorder, and what they need; private to the two files that implement it.
#include <deltaform/base/write_behind.h>
#include <deltaform/results/history.h>
#include <deltaform/results/picture_series.h>
#include <deltaform/results/units.h>
#include <deltaform/scene/checkpoint.h>
#include <deltaform/scene/recorder.h>
#include <deltaform/scene/simulation.h>

#include <set>

namespace deltaform
{
  /// The open files, and what they need.
  struct Recorder::Files
  {
    Files(Scene &the_scene, std::string the_folder, Journal &the_journal, Timers &the_timers, const Checkpoint *start)
      : scene(the_scene), folder(std::move(the_folder)), journal(the_journal), timers(the_timers),
        timer(timers.section("13 output")), units(scene.units), pictures(folder + "/scene.pvd")
    {
      const bool round = scene.actors.blank->axisymmetric();
      comments = {scene.title,
                  std::string("deltaform ") + DELTAFORM_VERSION + ", units: " + scene.units,
                  std::string("Forces are those of the blank on the tool, ") +
                    (round ? "for the full circumference (2 pi)." : "per unit width (plane strain).")};
      std::vector<std::string> names;
      for (const auto &tool : scene.actors.tools)
        names.push_back(tool->name());
      HistoryOptions options;
      options.condition = scene.output->condition_every > 0;
      options.refinement = scene.actors.blank->refinement() != nullptr;
      options.energies = scene.output->energies;
      options.iterative = scene.linear_solver->iterative();
      if (start)
        options.resume_after = start->increment;
      for (const auto &support : scene.actors.supports)
        options.supports.push_back(support.name);
      for (const auto &load : scene.actors.loads)
        options.loads.push_back(load.name);
      history = std::make_unique<History>(folder + "/history.csv", comments, names, units, options);
    }

    /// Works, energies and their balance.
    void add_energies(const FormingProblem &problem, HistoryRow &row) const;

    HistoryRow row(const FormingProblem &problem,
                   const Stage &stage,
                   double time,
                   unsigned int increment,
                   const IncrementCost &cost) const;

    void write_tables(const FormingProblem &problem, double travel, const std::string &stage);

    /// Of contact_<travel>.csv: the active pairs.
    using Rows = std::vector<std::vector<CsvWriter::Cell>>;
    static Rows contact_rows(const FormingProblem &problem);

    /// Blank and tools as files, and as an entry of the series.
    void write_picture(const FormingProblem &problem, const std::string &stage, double time);

    /// Values at the nodes of the blank: contact, and pressures that act on it.
    std::vector<DrawnField> nodal_fields(const FormingProblem &problem, const std::string &stage, double time) const;
    void show_progress(const HistoryRow &row) const;

    /// Travel of the main tool, or time where there is none.
    double main_travel(const FormingProblem &problem, const double time) const
    {
      return scene.output->main_tool == invalid_index ? time : problem.travel(scene.output->main_tool);
    }

    Scene &scene;
    std::string folder;
    Journal &journal;
    Timers &timers;
    Timers::Index timer;
    Units units;
    std::vector<std::string> comments;
    std::unique_ptr<History> history;
    PictureSeries pictures; ///< written by the tasks behind
    unsigned int n_pictures = 0;
    unsigned int next_frame = 0, iterations = 0, cutbacks = 0, rounds = 0, correction_iterations = 0;
    HistoryRow last;
    double worst_promise = 0, largest_force = 0, worst_between = 0;
    std::set<std::string> labels; ///< of the tables written so far
    double saved_at = 0; ///< seconds since the start

    /// What a resumed run cannot find out from the problem.
    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &next_frame &iterations &correction_iterations &cutbacks &rounds &worst_promise &worst_between &labels
        &last_picture;
    }

    double last_picture = -1; ///< its time
    WriteBehind behind; ///< last member: its task uses the others
  };
} // namespace deltaform
