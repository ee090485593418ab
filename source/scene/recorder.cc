#include <deltaform/base/atomic_file.h>
#include <deltaform/base/command_line.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/base/text.h>
#include <deltaform/results/history.h>
#include <deltaform/results/json.h>
#include <deltaform/results/table_file.h>
#include <deltaform/results/vtu.h>
#include <deltaform/scene/recorder.h>
#include <deltaform/scene/simulation.h>

#include <deal.II/base/config.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ostream>

namespace deltaform
{
  namespace
  {
    std::string
    rounded(const double value, const char *const format = "%.4g")
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, format, value);
      return buffer;
    }
  } // namespace



  /// The open files, and what they need.
  struct Recorder::Files
  {
    Files(Scene &the_scene, std::string the_folder, Journal &the_journal, Timers &the_timers)
      : scene(the_scene)
      , folder(std::move(the_folder))
      , journal(the_journal)
      , timers(the_timers)
      , timer(timers.section("13 output"))
      , units(scene.units)
      , pictures(folder + "/scene.pvd")
    {
      const bool round = scene.actors.blank->axisymmetric();
      comments         = {scene.title,
                          std::string("deltaform ") + DELTAFORM_VERSION + ", units: " + scene.units,
                          std::string("Forces are those of the blank on the tool, ") +
                            (round ? "for the full circumference (2 pi)." : "per unit width (plane strain).")};
      std::vector<std::string> names;
      for (const auto &tool : scene.actors.tools)
        names.push_back(tool->name());
      history = std::make_unique<History>(folder + "/history.csv", comments, names, units);
    }

    HistoryRow
    row(const FormingProblem &problem, const Stage &stage, double time, unsigned int increment, const IncrementCost &cost) const;

    void
    write_tables(const FormingProblem &problem, double travel) const;
    void
    write_contact(const FormingProblem &problem, double travel) const;
    void
    write_picture(const FormingProblem &problem, double time);
    void
    show_progress(const HistoryRow &row) const;

    /// Travel of the main tool, or time where there is none.
    double
    main_travel(const FormingProblem &problem, const double time) const
    {
      return scene.output->main_tool == invalid_index ? time : problem.travel(scene.output->main_tool);
    }

    Scene &                  scene;
    std::string              folder;
    Journal &                journal;
    Timers &                 timers;
    Timers::Index            timer;
    Units                    units;
    std::vector<std::string> comments;
    std::unique_ptr<History> history;
    PictureSeries            pictures;
    unsigned int             next_frame = 0, iterations = 0, cutbacks = 0, rounds = 0;
    HistoryRow               last;
    double                   worst_promise = 0, largest_force = 0, worst_between = 0;
    unsigned int             tables_written = 0;
  };



  Recorder::Recorder(Scene &scene, const std::string &folder, Journal &journal, Timers &timers)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw SceneError("Cannot make the folder '" + folder + "' for the results: " + error.message() +
                       ". Choose another with --output or Output/Folder.");
    write_file_atomically(folder + "/scene.prm", [&](std::ostream &out) {
      out << "# deltaform " << DELTAFORM_VERSION << ", deal.II " << DEAL_II_PACKAGE_VERSION
          << ": the scene as read, with every default.\n";
      scene.tree.print_prm(out);
    });
    journal.open_log(folder + "/run.log");
    files_ = std::make_unique<Files>(scene, folder, journal, timers);
    journal.detail("deltaform " + std::string(DELTAFORM_VERSION) + ", deal.II " + DEAL_II_PACKAGE_VERSION + ", scene " +
                   scene.tree.file_name());
  }



  Recorder::~Recorder() = default;



  HistoryRow
  Recorder::Files::row(const FormingProblem &problem,
                       const Stage &         stage,
                       const double          time,
                       const unsigned int    increment,
                       const IncrementCost & cost) const
  {
    HistoryRow row;
    row.increment         = increment;
    row.stage             = stage.name;
    row.time              = time;
    row.newton_iterations = cost.iterations;
    row.penalty_rounds    = cost.rounds;
    row.cutbacks          = cost.cutbacks;
    for (unsigned int i = 0; i < scene.actors.tools.size(); ++i)
      row.tools.push_back({problem.travel(i), problem.tool_forces()[i][1], problem.tool_forces()[i][0]});

    unsigned int  governed = 0;
    ContactEnergy contact;
    row.min_epsilon = std::numeric_limits<double>::infinity();
    for (const auto *pair : problem.active_pairs())
      {
        for (unsigned int i = 0; i < pair->n_nodes(); ++i)
          {
            const PairState &state = pair->committed()[i];
            if (!state.touching)
              continue;
            ++row.contact_pairs;
            row.max_penetration            = std::max(row.max_penetration, state.penetration());
            row.max_penetration_over_delta = std::max(row.max_penetration_over_delta, state.penetration() / state.delta);
            row.min_epsilon                = std::min(row.min_epsilon, state.epsilon);
            row.max_epsilon                = std::max(row.max_epsilon, state.epsilon);
            governed += pair->governed_by_floor(i);
          }
        row.max_penetration_between_nodes =
          std::max(row.max_penetration_between_nodes, pair->penetration_between_nodes(problem.committed()));
      }
    for (const auto &pair : scene.actors.pairs)
      contact += pair->energy();
    if (row.contact_pairs == 0)
      row.min_epsilon = 0.;
    else
      row.floor_share = static_cast<double>(governed) / row.contact_pairs;

    const BlankEnergy blank = scene.actors.blank->energy();
    row.min_thickness       = scene.actors.blank->smallest_thickness();
    row.tool_work           = problem.work().tools;
    row.load_work           = problem.work().loads;
    row.elastic_energy      = blank.elastic;
    row.plastic_energy      = blank.plastic;
    row.friction_energy     = contact.friction;
    row.contact_energy      = contact.stored;
    row.epsilon_work        = contact.epsilon;
    row.thickness_work      = contact.thickness + blank.normal;
    const double in         = row.tool_work + row.load_work + row.epsilon_work + row.thickness_work;
    const double out        = row.elastic_energy + row.plastic_energy + row.friction_energy + row.contact_energy;
    const double size = std::max({std::abs(row.tool_work), std::abs(row.load_work), std::abs(out)});
    row.energy_error  = size > 0 ? (in - out) / size : 0.;
    return row;
  }



  void
  Recorder::record(const FormingProblem &problem,
                   const Stage &         stage,
                   const double          time,
                   const unsigned int    increment,
                   const IncrementCost & cost)
  {
    Timers::Scope scope(files_->timers, files_->timer);
    files_->last = files_->row(problem, stage, time, increment, cost);
    files_->history->append(files_->last);
    files_->iterations += cost.iterations;
    files_->rounds += cost.rounds;
    files_->cutbacks += cost.cutbacks;
    files_->worst_promise = std::max(files_->worst_promise, files_->last.max_penetration_over_delta);
    files_->worst_between = std::max(files_->worst_between, files_->last.max_penetration_between_nodes);

    const auto &output = *files_->scene.output;
    for (const double asked : output.travel_times)
      if (std::abs(time - asked) <= 1e-9 * std::max(1., std::abs(asked)))
        files_->write_tables(problem, files_->main_travel(problem, time));
    bool picture = false;
    while (files_->next_frame < output.frame_times.size() && time >= output.frame_times[files_->next_frame] * (1 - 1e-12))
      {
        picture = true;
        ++files_->next_frame;
      }
    if (picture)
      files_->write_picture(problem, time);
    files_->show_progress(files_->last);
  }



  void
  Recorder::Files::show_progress(const HistoryRow &row) const
  {
    const double      end    = scene.actors.stages.back().end;
    const double      spent  = timers.total();
    const auto        main   = scene.output->main_tool;
    std::string       line   = "increment " + std::to_string(row.increment) + "  " + row.stage + " t = " + rounded(row.time);
    if (main != invalid_index)
      line += "  " + scene.actors.tools[main]->name() + ": travel " + rounded(row.tools[main].travel) + ", force " +
              rounded(row.tools[main].force_z);
    line += "  iterations " + std::to_string(iterations);
    if (scene.actors.contact && scene.actors.contact->enforcement->uses_penalty())
      line += "  p/delta <= " + rounded(worst_promise, "%.3f");
    line += "  left " + rounded(spent * (end - row.time) / std::max(row.time, 1e-300), "%.1f") + " s";
    journal.progress(line);
  }



  void
  Recorder::Files::write_tables(const FormingProblem &problem, const double travel) const
  {
    auto head = comments;
    head.push_back("travel of the main tool (or time): " + text::format(travel));
    write_table(folder + "/" + table_name("profile", travel), head, scene.actors.blank->profile(problem.committed()), units);
    if (scene.actors.tools.empty())
      return;
    write_contact(problem, travel);

    double reach = 0.;
    for (const auto &x : scene.actors.blank->positions(problem.committed()))
      reach = std::max(reach, x.norm());
    CsvWriter tools(folder + "/" + table_name("tools", travel),
                    head,
                    {{"tool", "1"}, {"r", units.of("length")}, {"z", units.of("length")}});
    for (const auto *pair : problem.active_pairs())
      for (const auto &x : pair->tool().polyline(pair->travel(problem.committed()), reach))
        tools.row_of_cells({pair->tool().name(), x[0], x[1]});
  }



  void
  Recorder::Files::write_contact(const FormingProblem &problem, const double travel) const
  {
    auto head = comments;
    head.push_back("every touching pair at travel (or time) " + text::format(travel));
    CsvWriter file(folder + "/" + table_name("contact", travel),
                   head,
                   {{"tool", "1"},
                    {"R0", units.of("length")},
                    {"penetration", units.of("length")},
                    {"delta", units.of("length")},
                    {"epsilon", units.of("force/length")},
                    {"normal_force", units.of("force")},
                    {"pressure", units.of("stress")},
                    {"slip", units.of("length")},
                    {"tangential_force", units.of("force")},
                    {"status", "1"}});
    for (const auto *pair : problem.active_pairs())
      for (unsigned int i = 0; i < pair->n_nodes(); ++i)
        {
          const PairState &state = pair->committed()[i];
          if (!state.touching)
            continue;
          const ContactNode node = pair->node(problem.committed(), i);
          file.row_of_cells({pair->tool().name(),
                             node.reference_coordinate,
                             state.penetration(),
                             state.delta,
                             state.epsilon,
                             state.force,
                             node.area > 0 ? state.force / node.area : 0.,
                             state.slip,
                             state.tangential_force,
                             std::string(pair->tool().friction_coefficient() == 0 ? "frictionless" :
                                         state.sticking                           ? "stick" :
                                                                                    "slip")});
        }
  }



  void
  Recorder::Files::write_picture(const FormingProblem &problem, const double time)
  {
    const auto &            blank = *scene.actors.blank;
    std::vector<DrawnField> fields;
    if (!scene.actors.tools.empty())
      {
        const unsigned int n = blank.n_contact_nodes(Side::top);
        fields               = {{"penalty_factor", "force/length", true, 1, std::vector<double>(n, 0.)},
                                {"penetration_over_delta", "1", true, 1, std::vector<double>(n, 0.)},
                                {"contact_pressure", "stress", true, 1, std::vector<double>(n, 0.)},
                                {"contact_status", "0 free 1 slip 2 stick", true, 1, std::vector<double>(n, 0.)}};
        for (const auto *pair : problem.active_pairs())
          {
            const auto pressure = pair->pressure(problem.committed());
            for (unsigned int i = 0; i < n; ++i)
              {
                const PairState &state = pair->committed()[i];
                if (!state.touching)
                  continue;
                fields[0].values[i] = std::max(fields[0].values[i], state.epsilon);
                fields[1].values[i] = std::max(fields[1].values[i], state.penetration() / state.delta);
                fields[2].values[i] = std::max(fields[2].values[i], pressure[i]);
                fields[3].values[i] = std::max(fields[3].values[i], state.sticking ? 2. : 1.);
              }
          }
      }
    char number[16];
    std::snprintf(number, sizeof number, "_%04u.vtu", pictures.size());
    std::vector<std::string> parts{std::string("blank") + number};
    write_vtu(folder + "/" + parts[0], blank.draw(problem.committed(), fields), units);

    double reach = 0.;
    for (const auto &x : blank.positions(problem.committed()))
      reach = std::max(reach, x.norm());
    Drawing tools;
    tools.points_per_cell = 2;
    DrawnField index{"tool", "index", false, 1, {}};
    double     which = -1.;
    for (const auto *pair : problem.active_pairs())
      {
        const auto points = pair->tool().polyline(pair->travel(problem.committed()), reach);
        which += 1.;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            if (i > 0)
              {
                tools.cells.push_back(tools.points.size() - 1);
                tools.cells.push_back(tools.points.size());
                index.values.push_back(which);
              }
            tools.points.push_back(points[i]);
          }
      }
    if (!tools.cells.empty())
      {
        tools.fields.push_back(index);
        parts.push_back(std::string("tools") + number);
        write_vtu(folder + "/" + parts[1], tools, units);
      }
    pictures.add(time, parts);
  }



  void
  Recorder::finish(const int exit_status, const FormingProblem &problem, const unsigned int increments, const unsigned int iterations)
  {
    auto &files = *files_;
    {
      Timers::Scope scope(files.timers, files.timer);
      if (exit_status != exit_status::done && increments > 0)
        {
          files.write_tables(problem, files.main_travel(problem, files.last.time));
          files.write_picture(problem, files.last.time);
        }
    }
    JsonObject summary;
    summary.add("title", files.scene.title);
    summary.add("units", files.scene.units);
    summary.add("version", std::string(DELTAFORM_VERSION));
    summary.add("exit_status", exit_status);
    summary.add("outcome",
                std::string(exit_status == exit_status::done          ? "done" :
                            exit_status == exit_status::not_converged ? "not converged" :
                                                                        "promise p <= delta could not be kept"));
    summary.add("unknowns", static_cast<double>(problem.committed().size()));
    summary.add("increments", increments);
    summary.add("newton_iterations", iterations);
    summary.add("penalty_rounds", files.rounds);
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
    summary.add("energy_error", files.last.energy_error);
    summary.add("seconds", files.timers.total());
    write_file_atomically(files.folder + "/summary.json", [&](std::ostream &out) { out << summary.to_string() << '\n'; });
    write_file_atomically(files.folder + "/timing.json", [&](std::ostream &out) { files.timers.write_json(out); });

    files.journal.finish_progress();
    const auto main = files.scene.output->main_tool;
    std::string line = std::to_string(increments) + " increments, " + std::to_string(iterations) + " Newton iterations, " +
                       rounded(files.timers.total(), "%.2f") + " s";
    if (main != invalid_index && !files.last.tools.empty())
      line = files.scene.actors.tools[main]->name() + ": travel " + rounded(files.last.tools[main].travel) + ", force " +
             rounded(files.last.tools[main].force_z, "%.6g") + "; thinnest " + rounded(files.last.min_thickness) + "; " + line;
    if (files.scene.actors.contact && files.scene.actors.contact->enforcement->uses_penalty())
      line += "; max p/delta " + rounded(files.worst_promise, "%.3f");
    files.journal.note(line);
    files.journal.note("results in " + files.folder);
  }
} // namespace deltaform
