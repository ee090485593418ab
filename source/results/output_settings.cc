#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/results/output_settings.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  OutputSettings::OutputSettings(Section &section,
                                 const std::vector<std::unique_ptr<Tool>> &tools,
                                 const std::vector<Stage> &stages)
    : folder(
        section.text("Folder", Default<std::string>(""), "Folder of the results; empty: output/<name of the scene>.")),
      travels(
        section.numbers("Travels",
                        "",
                        "length",
                        "Travels of the main tool at which profile_*.csv, contact_*.csv and tools_*.csv are written; "
                        "the increments meet them. Empty, and no Times: at the end of each stage.")),
      times(section.numbers("Times", "", "time",
                            "Times at which the same tables are written, beside Travels; the increments meet them."))
  {
    std::vector<std::string> names{""};
    for (const auto &tool : tools)
      names.push_back(tool->name());
    const std::string main = section.choice("Travel of", "", names, "The main tool; empty: the first that moves.");
    const int frames =
      section.integer("Pictures",
                      20,
                      0,
                      100000,
                      "Pictures for ParaView, at equal distances in time, after one of the undeformed blank; 0: none.");

    condition_every = section.integer("Condition number every",
                                      0,
                                      0,
                                      1000000,
                                      "Condition numbers of the tangent in every so many increments; 0: never.");
    const std::string method = section.choice(
      "Condition number by",
      "automatic",
      {"automatic", "dense", "lanczos"},
      "How singular values are computed: dense, by Lanczos iterations, or (automatic) dense for up to 300 unknowns.");
    condition_method = method == "dense"     ? condition::Method::dense
                       : method == "lanczos" ? condition::Method::lanczos
                                             : condition::Method::automatic;

    energies =
      section.flag("Energies",
                   true,
                   "Works and energies in history.csv and their balance, energy_error, in summary.json. Without "
                   "them an increment costs some percent less.");

    checkpoint_interval = section.number("Checkpoint interval",
                                         5.,
                                         Range::not_negative(),
                                         "s",
                                         "Wall time between saved states, from which --resume goes on; 0: after every "
                                         "increment. One is also saved at the end of every stage and of the run.");

    const double end = stages.back().end;
    choose_main_tool(main, tools, end);
    find_table_times(section, tools, stages);
    read_measures(section.sub("Measures"));
    for (int i = 1; i <= frames; ++i)
      frame_times.push_back(end * i / frames);
  }


  void OutputSettings::find_table_times(const Section &section, const std::vector<std::unique_ptr<Tool>> &tools,
                                        const std::vector<Stage> &stages)
  {
    const double end = stages.back().end;
    at_stage_ends = travels.empty() && times.empty();
    if (at_stage_ends)
      for (const auto &stage : stages)
        travel_times.push_back(stage.end);
    if (!travels.empty())
      find_travel_times(section, tools, end);
    for (const double time : times)
    {
      if (!(time > 0. && time <= end))
        section.fail("Times", text::format(time) + " is not between the start and the end of the process, " +
                                text::format(end));
      travel_times.push_back(time);
    }
    std::sort(travel_times.begin(), travel_times.end());
    travel_times.erase(std::unique(travel_times.begin(), travel_times.end()), travel_times.end());
  }


  void OutputSettings::read_measures(Section section)
  {
    auto names = section.section_names("Names", "", "Radii, angles and lengths of the finished part, one subsection "
                                                    "each; summary.json has them.");
    if (section.documentation())
      names = {"<name>"};
    for (const auto &name : names)
    {
      Section own = section.sub(name);
      measures.push_back(MeasureRegistry::choose(own, "Kind", "u-bend", "What is measured."));
    }
  }


  void OutputSettings::choose_main_tool(const std::string &name, const std::vector<std::unique_ptr<Tool>> &tools,
                                        const double end)
  {
    const auto moves = [end](const Tool &tool) {
      const auto range = tool.travel_range(0., end);
      return !tool.force_driven() && range.first != range.second;
    };
    for (unsigned int i = 0; i < tools.size(); ++i)
      if (tools[i]->name() == name || (name.empty() && main_tool == invalid_index && moves(*tools[i])))
        main_tool = i;
  }


  void OutputSettings::find_travel_times(const Section &section, const std::vector<std::unique_ptr<Tool>> &tools,
                                         const double end)
  {
    if (main_tool == invalid_index || tools[main_tool]->force_driven())
      section.fail("Travels", "there is no tool that is moved: leave this empty");
    for (const double travel : travels)
    {
      const double time = tools[main_tool]->time_of_travel(travel, 0., end);
      if (std::isnan(time))
        section.fail("Travels", "tool '" + tools[main_tool]->name() + "' never reaches " + text::format(travel));
      travel_times.push_back(time);
    }
  }
} // namespace deltaform
