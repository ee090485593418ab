#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/unit_system.h>
#include <deltaform/parameters/units_label.h>
#include <deltaform/scene/contact_edge.h>
#include <deltaform/scene/known_entries.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace deltaform
{
  namespace
  {
    /// Names of subsections; the documentation has one of each kind.
    std::vector<std::string> named(Section section, const std::string &sentence)
    {
      const auto names = section.section_names("Names", "", sentence);
      return section.documentation() ? std::vector<std::string>{"<name>"} : names;
    }

    /// An entry of Contact that the scene states, although it makes sense with tools only; null: none.
    const char *given_contact_entry(const Section &contact)
    {
      for (const auto *const entry : {"Penalty rule", "Enforcement", "Allowed penetration", "Penalty factor"})
        if (contact.given(entry))
          return entry;
      return nullptr;
    }

    void check_described(const std::string &name, const Section &tool, const Section &tools)
    {
      if (!tool.given("Side") && !tool.given("Shape"))
        tools.fail("Names", "there is no subsection '" + name +
                              "' with Side and Shape of this tool. Names are separated by commas");
    }


    /// Lengths that expressions may name.
    std::map<std::string, double> lengths(const Blank &blank, const bool of_contact)
    {
      std::map<std::string, double> result{{"thickness", blank.initial_thickness()}};
      if (of_contact)
        result["edge"] = shortest_contact_edge(blank);
      return result;
    }


    /// What delta is compared with. The thickness of a solid may be any number of cells, and of Hertz's half-space it
    /// is none.
    std::string natural_length(const Blank &blank)
    {
      return blank.fields().is_sheet() ? "thickness" : "edge";
    }


    /// Nothing presses the sheet on a tool by a force, or between two tools, and it is held at one place of its outline
    /// at most.
    bool sheet_slides(const Actors &actors)
    {
      std::array<unsigned int, 2> n_tools{{0, 0}}; // of each side
      for (const auto &tool : actors.tools)
        if (tool->force_driven() || ++n_tools[static_cast<unsigned int>(tool->side())] > 1)
          return false;
      std::set<std::string> held;
      for (const Support &support : actors.supports)
        if (support.component != Component::rotation)
          held.insert(support.boundary);
      return held.size() < 2;
    }
  } // namespace


  Scene::Scene(ParameterTree &parameters)
    : tree(parameters)
  {
    Section root = tree.root();
    title = root.text("Title", Default<std::string>("a deltaform scene"), "What this scene is.");
    units = read_units_label(root);
    if (const std::string objection = UnitSystem(units).objection(); !objection.empty())
      root.fail("Units", objection);
    start_from = root.text("Start from", Default<std::string>(""),
                           "Folder with the results of an earlier operation; the blank begins as that run left it. "
                           "Section Blank must be that of the earlier scene, but for Elements, Grading, Refinement, "
                           "Degree of a solid, Contact points, and Points that end earlier (trimmed) or begin later "
                           "(pierced).");
    actors.formed_before = !start_from.empty();

    Section blank = root.sub("Blank");
    supply_material(root);
    actors.blank = Registry<Blank>::choose(blank, "Kind", "shell", "How the blank is modelled.");
    build_tools(root);
    read_supports_and_loads(root);
    build_interfaces(root);
    actors.heat = HeatFlow::read(root, *actors.blank, actors.interfaces);

    Section steps_section = root.sub("Steps");
    actors.stages = read_stages(steps_section);

    std::vector<std::string> criteria;
    for (const auto &criterion : actors.blank->fields().largest_criteria())
      criteria.push_back(criterion.name);
    actors.limits = read_limits(root, criteria);

    actors.wrinkling = FlangeWrinkling::read(root, *actors.blank);

    Section solver = root.sub("Solver");
    newton = std::make_unique<NewtonSettings>(solver);
    // Of a solid short increments save nothing (doc/decisions/README.md).
    steps = std::make_unique<StepSettings>(solver, actors.blank->fields().is_sheet() ? 5 : 8);
    linear_solver = std::make_unique<LinearSolverSettings>(solver);

    Section output_section = root.sub("Output");
    output = std::make_unique<OutputSettings>(output_section, actors.tools, actors.stages);

    if (root.documentation())
      return;
    std::optional<KnownEntries> known; // asked for seldom
    auto dropped = tree.drop_replaced([&known](const SectionPath &path, const std::string &name) {
      if (!known)
        known.emplace();
      return known->contain(path, name);
    });
    notes.insert(notes.end(), dropped.begin(), dropped.end());
    tree.check_unused();
    const Section contact = root.sub("Contact");
    if (const char *const entry = given_contact_entry(contact); entry != nullptr && actors.tools.empty())
      contact.fail(entry, "there is no tool to touch: name one in Tools/Names, or drop the section Contact");
    check(root);
  }


  AnalysisSettings Scene::analysis_settings() const
  {
    return {*linear_solver, *newton, *steps, output->travel_times, output->energies,
            Checkpoint::entries(tree)};
  }


  void Scene::read_supports_and_loads(const Section &root)
  {
    for (const auto &name : named(root.sub("Supports"), "Prescribed displacements, one subsection each."))
      actors.supports.emplace_back(name, root.sub("Supports").sub(name), *actors.blank);
    for (const auto &name : named(root.sub("Loads"), "Loads, one subsection each."))
    {
      Section own = root.sub("Loads").sub(name);
      actors.loads.push_back(LoadRegistry::choose(own, "Kind", "pressure", "What kind of load it is.", *actors.blank));
    }

    const Section probes = root.sub("Output").sub("Probes");
    for (const auto &name : named(probes, "Places of the blank that are watched over time, one subsection each."))
      actors.probes.emplace_back(name, probes.sub(name), *actors.blank);
  }


  void Scene::build_tools(const Section &root)
  {
    const Section section = root.sub("Tools");
    const auto names = named(section, "Names of the tools, one subsection each.");
    Section contact = root.sub("Contact");
    // Without tools the section Contact is refused, but first what may be meant by 'Tools': its entries are declared.
    if (names.empty() && given_contact_entry(contact) == nullptr)
      return;
    const auto constants = lengths(*actors.blank, false), contact_constants = lengths(*actors.blank, true);
    const std::string natural = natural_length(*actors.blank);
    if (names.empty())
    {
      const ContactSettings declared(contact, contact_constants, natural);
      return;
    }
    actors.contact = std::make_unique<ContactSettings>(contact, contact_constants, natural);
    for (const auto &name : names)
    {
      const Section own = section.sub(name);
      if (!section.documentation())
        check_described(name, own, section);
      actors.tools.push_back(
        std::make_unique<Tool>(name, own, constants, contact_constants, actors.blank->axisymmetric()));
    }
  }


  void Scene::build_interfaces(const Section &root)
  {
    if (actors.tools.empty())
      return;
    const Section section = root.sub("Tools");
    choose_contact_points(section);
    if (const Section contact = root.sub("Contact");
        actors.blank->surface().points_move() && !actors.contact->finds_factors())
      contact.fail("Enforcement", "a moving contact point (Blank/Contact points) wants a factor of its own that is found: "
                                  "use 'penalty' with Penalty rule = adaptive");
    for (const auto &tool : actors.tools)
    {
      Section own = section.sub(tool->name());
      actors.interfaces.push_back(std::make_unique<ContactInterface>(
        actors.blank->surface(), *tool, make_counterpart(*tool), *actors.contact, own));
      if (const FrictionLaw *law = actors.interfaces.back()->friction(); law != nullptr && law->needs_flow_stress())
        actors.blank->follow_flow_stress(tool->side());
    }
  }


  void Scene::choose_contact_points(const Section &section)
  {
    // Points of rigid faces would come and go with a fine delta (doc/decisions/README.md, "Points inside, and a fine
    // delta").
    const DeltaSize delta =
      actors.contact->delta_size(lengths(*actors.blank, true)[natural_length(*actors.blank)]);
    const bool gives_way = std::all_of(actors.tools.begin(), actors.tools.end(), [&](const auto &tool) {
      Section own = section.sub(tool->name());
      return ContactProjector::reads_compliance(own);
    });
    if (actors.contact->finds_factors() && (gives_way || delta == DeltaSize::coarse))
      actors.blank->touch_inside(delta, sheet_slides(actors));
  }
} // namespace deltaform
