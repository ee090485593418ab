#include <deltaform/analysis/state.h>
#include <deltaform/blanks/blank.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/reports/checkpoint.h>
#include <deltaform/scene/earlier_operation.h>
#include <deltaform/scene/scene.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace deltaform
{
  namespace
  {
    std::optional<Checkpoint> saved_state(const Scene &scene)
    {
      try
      {
        return Checkpoint::read(scene.start_from);
      }
      catch (const SceneError &)
      {
        // Which speaks of a run that is resumed.
        scene.tree.fail({}, "Start from",
                        "the saved state (" + Checkpoint::path(scene.start_from) +
                          ") is damaged or was written by another version. Run the earlier operation again.");
      }
    }


    std::string text_of(const nlohmann::json &object, const char *const name)
    {
      const auto found = object.find(name);
      return found != object.end() && found->is_string() ? found->get<std::string>() : "for no reason that was saved";
    }
  } // namespace


  std::string missing_start(const Scene &scene)
  {
    if (scene.start_from.empty() || saved_state(scene))
      return "";
    return "there is no saved state (" + Checkpoint::path(scene.start_from) +
           "). Run the earlier operation first, with this folder as its --output.";
  }


  std::vector<std::string> doubts_about_start(const Scene &scene)
  {
    if (scene.start_from.empty() || !std::filesystem::exists(Checkpoint::path(scene.start_from)))
      return {};
    const std::string begin = "Start from = " + scene.start_from + ": the earlier operation ",
                      path = scene.start_from + "/summary.json";
    std::ifstream file(path);
    const auto summary = nlohmann::json::parse(file, nullptr, false);
    if (!summary.is_object() || !summary.contains("exit_status") || !summary.contains("warnings"))
      return {begin + "has not come to its end (there is no " + path + "); the blank begins as it was saved last."};
    std::vector<std::string> result;
    if (summary["exit_status"] != 0)
      result.push_back(begin + "stopped, and the blank begins as it was then: " + text_of(summary, "message"));
    std::string kinds;
    for (const auto &warning : summary["warnings"])
      if (const auto *const text = warning.get_ptr<const std::string *>())
        kinds += (kinds.empty() ? "" : "; ") + text->substr(0, text->find(": "));
    if (!kinds.empty())
      result.push_back(begin + "ended with warnings (" + path + "), which are about this part as well: " + kinds + ".");
    return result;
  }


  KeyedArrays formed_blank(const Scene &scene)
  {
    if (const std::string missing = missing_start(scene); !missing.empty())
      scene.tree.fail({}, "Start from", missing);
    const Checkpoint checkpoint = *saved_state(scene);
    // A blank of its own, as the earlier scene had it; a metal with rates or heat asks for the unit of time, and what
    // is measured at its points is named in Limits.
    std::vector<std::string> entries;
    for (const auto &[name, value] : checkpoint.scene)
      if (name == "Units" || name.rfind("Blank/", 0) == 0 || name.rfind("Material/", 0) == 0 ||
          name.rfind("Limits/", 0) == 0)
        entries.push_back(name + "=" + value);
    ParameterTree tree = ParameterTree::parse("", scene.start_from + "/scene.prm", entries);
    Section section = tree.root().sub("Blank");
    const auto blank = Registry<Blank>::choose(section, "Kind", "shell", "How the blank is modelled.");
    State state;
    std::istringstream bytes(checkpoint.state);
    state.load(bytes);
    blank->set_state(state.model.body);
    blank->begin_increment(0., 0.);
    return blank->formed(state.model.unknowns);
  }
} // namespace deltaform
