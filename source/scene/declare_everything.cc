// The documentation of all parameters: every registered object declares its entries once.
#include <deltaform/base/registry.h>
#include <deltaform/materials/back_stress.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/materials/yield_surface.h>
#include <deltaform/scene/scene.h>

namespace deltaform
{
  namespace
  {
    template <typename T>
    void declare_each(Section section, const std::string &entry)
    {
      for (const auto &name : Registry<T>::names())
      {
        Section own = section.sub(entry + ": " + name);
        Registry<T>::make(name, own);
      }
    }
  } // namespace


  void declare_everything(ParameterTree &tree)
  {
    Section root = tree.root();
    root.text("Title", Default<std::string>("a deltaform scene"), "What this scene is.");
    root.text("Units", Default<std::string>("consistent"), "Label of the units, for example 'mm, N, MPa'.");
    Section blank_section = root.sub("Blank");
    auto blank = Registry<Blank>::choose(blank_section, "Kind", "shell", "How the blank is modelled.");
    declare_each<Blank>(blank_section, "Kind");
    declare_each<Material>(root.sub("Material"), "Model");
    declare_each<Hardening>(root.sub("Material").sub("Hardening"), "Law");
    declare_each<YieldSurface>(root.sub("Material").sub("Yield surface"), "Law");
    declare_each<BackStress>(root.sub("Material").sub("Backstress"), "Law");
    declare_each<RateFactor>(root.sub("Material").sub("Rate factor"), "Law");

    const std::map<std::string, double> constants{{"thickness", blank->initial_thickness()}};
    Section contact_section = root.sub("Contact");
    const ContactSettings contact(contact_section, constants);
    declare_each<Enforcement>(contact_section, "Enforcement");
    declare_each<PenaltyRule>(contact_section, "Penalty rule");

    std::vector<std::unique_ptr<Tool>> tools;
    Section tools_section = root.sub("Tools");
    tools_section.section_names("Names", "", "Names of the tools, one subsection each.");
    Section tool_section = tools_section.sub("<name>");
    tools.push_back(std::make_unique<Tool>("<name>", tool_section, constants, constants));
    const ContactInterface pair(*blank, *tools.front(), contact, tool_section);
    declare_each<Shape>(tool_section, "Shape");
    declare_each<FrictionLaw>(tool_section, "Friction law");

    root.sub("Supports").section_names("Names", "", "Prescribed displacements, one subsection each.");
    const Support support("<name>", root.sub("Supports").sub("<name>"), *blank);
    root.sub("Loads").section_names("Names", "", "Loads, one subsection each.");
    Section load_section = root.sub("Loads").sub("<name>");
    LoadRegistry::choose(load_section, "Kind", "pressure", "What kind of load it is.", *blank);
    for (const auto &name : LoadRegistry::names())
    {
      Section own = load_section.sub("Kind: " + name);
      LoadRegistry::make(name, own, *blank);
    }

    Section steps_section = root.sub("Steps");
    const auto stages = read_stages(steps_section);
    Section solver = root.sub("Solver");
    const NewtonSettings newton(solver);
    const StepSettings steps(solver);
    const LinearSolverSettings linear(solver);
    Section output_section = root.sub("Output");
    const OutputSettings output(output_section, tools, stages);
  }
} // namespace deltaform
