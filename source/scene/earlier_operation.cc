#include <deltaform/analysis/state.h>
#include <deltaform/blanks/blank.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/reports/checkpoint.h>
#include <deltaform/scene/earlier_operation.h>

#include <sstream>

namespace deltaform
{
  KeyedArrays formed_blank(const std::string &folder)
  {
    const auto checkpoint = Checkpoint::read(folder);
    if (!checkpoint)
      throw SceneError("Start from: '" + folder + "' has no saved state (" + Checkpoint::path(folder) +
                       "). Run the earlier operation first, with this folder as its --output.");
    // A blank of its own, as the earlier scene had it; a metal with rates or heat asks for the unit of time, and what
    // is measured at its points is named in Limits.
    std::vector<std::string> entries;
    for (const auto &[name, value] : checkpoint->scene)
      if (name == "Units" || name.rfind("Blank/", 0) == 0 || name.rfind("Material/", 0) == 0 ||
          name.rfind("Limits/", 0) == 0)
        entries.push_back(name + "=" + value);
    ParameterTree tree = ParameterTree::parse("", folder + "/scene.prm", entries);
    Section section = tree.root().sub("Blank");
    const auto blank = Registry<Blank>::choose(section, "Kind", "shell", "How the blank is modelled.");
    State state;
    std::istringstream bytes(checkpoint->state);
    state.load(bytes);
    blank->set_state(state.model.body);
    blank->begin_increment(0., 0.);
    return blank->formed(state.model.unknowns);
  }
} // namespace deltaform
