// What is wrong with a scene although every entry by itself is allowed.
#include <deltaform/checks/function_values.h>
#include <deltaform/checks/idle_stage.h>
#include <deltaform/checks/tool_placement.h>
#include <deltaform/conditions/stage_ends.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// The corners of a tool are Points; those of an outline its Path or its File.
    std::string as_stated(const std::string &entry, const Section &tool)
    {
      if (entry != "Points" || tool.given(entry))
        return entry;
      return tool.given("File") ? "File" : "Path";
    }
  } // namespace


  void Scene::check(const Section &root) const
  {
    check_functions(root);
    check_columns(root);
    check_tools(root);
    check_lifted_tools(root);
    check_stages(root);
    check_linear_solver(root);
    check_friction(root);
  }


  void Scene::check_friction(const Section &root) const
  {
    FrictionInput at_elastic_surface;
    at_elastic_surface.normal_force = at_elastic_surface.area = 1.;
    if (std::isfinite(actors.blank->initial_flow_stress()))
      return;
    for (const auto &interface : actors.interfaces)
      if (interface->friction() && !std::isfinite(interface->friction()->limit(at_elastic_surface).value))
        root.sub("Tools")
          .sub(interface->tool().name())
          .fail("Friction law",
                "is bounded by the flow stress of the blank alone, and an elastic material has none: take coulomb, or "
                "Material/Model = elastoplastic");
  }


  void Scene::check_linear_solver(const Section &root) const
  {
    if (linear_solver->iterative() && actors.contact && actors.contact->normal_law->has_multiplier())
      root.sub("Solver").fail("Linear solver",
                              "'" + linear_solver->name +
                                "' cannot solve with the multipliers of this enforcement: take klu or mumps");
    const bool part = actors.blank->locally_owned_dofs().n_elements() < actors.blank->n_dofs();
    if (output->condition_every > 0 && ranks::max(part ? 1. : 0.) > 0)
      root.sub("Output").fail("Condition number every",
                              "a condition number needs the whole matrix in one process: start without mpirun");
  }


  void Scene::check_functions(const Section &root) const
  {
    // What lies between is judged during the run.
    constexpr unsigned int n_samples = 200;
    const FunctionValues values(actors);
    const auto inspect = [&](const Stage &stage, const double time) {
      if (const auto wrong = values.find_wrong(stage, time))
      {
        const Section section = root.sub(wrong->section);
        (wrong->name.empty() ? section : section.sub(wrong->name)).fail(wrong->entry, wrong->message);
      }
    };
    for (const auto &stage : actors.stages)
    {
      for (unsigned int k = 0; k <= n_samples; ++k)
        inspect(stage, stage.begin + (stage.end - stage.begin) * k / n_samples);
      inspect(stage, std::min(stage.begin + stage.first_increment, stage.end));
    }
  }


  void Scene::check_columns(const Section &root) const
  {
    // Columns of history.csv, and the names that they have them from; those of the program first.
    std::map<std::string, std::string> taken;
    Columns own;
    for (const auto describe : {describe_contact, describe_thickness, describe_energies})
      describe(own);
    if (actors.wrinkling)
      describe_wrinkling(own);
    for (const auto &column : own.columns())
      taken.emplace(column.name, "(deltaform)");
    const auto take = [&](const Section &section, const std::string &name, const auto &describe) {
      Columns columns;
      describe(std::vector<std::string>{name}, columns);
      for (const auto &column : columns.columns())
        if (const auto [other, fresh] = taken.emplace(column.name, name); !fresh)
          section.fail("Names",
                       "'" + other->second + "' and '" + name + "' would both have the column '" +
                         column.name +
                         "' of history.csv, where underscores stand for blanks: rename one of them");
    };
    for (const auto &tool : actors.tools)
      take(root.sub("Tools"), tool->name(), describe_tools);
    for (const auto &support : actors.supports)
      take(root.sub("Supports"), support.name, describe_supports);
    for (const auto &load : actors.loads)
      take(root.sub("Loads"), load->name(), [&load](const std::vector<std::string> &names, Columns &columns) {
        describe_loads(names, columns);
        (load->pressed_face().empty() ? describe_load_sizes : describe_pressures)(names, columns);
        if (load->restraint())
          describe_beads(names, columns);
      });
    for (const auto &probe : actors.probes)
      take(root.sub("Output").sub("Probes"), probe.name(),
           [&probe](const std::vector<std::string> &, Columns &columns) { describe_probes({probe}, columns); });
  }


  void Scene::check_lifted_tools(const Section &root) const
  {
    for (const auto &load : actors.loads)
      if (const std::string name = load->lifted_tool(); !name.empty())
      {
        const auto tool = std::find_if(actors.tools.begin(), actors.tools.end(),
                                       [&](const auto &candidate) { return candidate->name() == name; });
        const Section section = root.sub("Loads").sub(load->name());
        if (tool == actors.tools.end())
          section.fail("Closes", "there is no tool '" + name + "'");
        if (!(*tool)->force_driven())
          section.fail("Closes", "tool '" + name + "' has a Motion, no Force that the bead could take a part of");
      }
  }


  void Scene::check_tools(const Section &root) const
  {
    const Vector zero(actors.blank->n_dofs());
    const double h = actors.blank->initial_thickness();
    double outermost = 0.;
    for (const auto &x : actors.blank->positions(zero))
      outermost = std::max(outermost, x[0]);

    for (unsigned int i = 0; i < actors.tools.size(); ++i)
    {
      const Tool &tool = *actors.tools[i];
      const Section section = root.sub("Tools").sub(tool.name());
      // What comes later is checked when it comes: the blank has another shape then (misplaced_tool).
      if (start_from.empty() && tool.exists_in(actors.stages.front().name))
      {
        if (const auto wrong = find_misplacement(*actors.blank, *actors.interfaces[i], zero, tool.travel(0.), 1e-9 * h))
          section.fail(as_stated(wrong->entry, section), wrong->message);
        const double opening = tool.shape().opening();
        if (opening > 0 && outermost <= opening)
          section.fail("Throat radius",
                       "the blank ends at r = " + text::format(outermost) + " and falls through the opening of tool '" +
                         tool.name() + "', radius " + text::format(opening));
      }
    }
  }


  void Scene::check_stages(const Section &root) const
  {
    const auto known = [&](const std::vector<std::string> &names, const Section &section) {
      for (const auto &name : names)
        if (std::none_of(actors.stages.begin(), actors.stages.end(),
                         [&](const Stage &stage) { return stage.name == name; }))
          section.fail("Stages", "there is no stage '" + name + "'");
    };
    for (const auto &tool : actors.tools)
      known(tool->stages(), root.sub("Tools").sub(tool->name()));
    for (const auto &support : actors.supports)
      known(support.stages, root.sub("Supports").sub(support.name));
    for (const auto &load : actors.loads)
      known(load->stages(), root.sub("Loads").sub(load->name()));

    const StageEnds ends(actors);
    const Stage *before = nullptr;
    for (const auto &stage : actors.stages)
    {
      try
      {
        ends.check(stage);
      }
      catch (const std::invalid_argument &error)
      {
        root.sub("Steps").sub(stage.name).fail("Ends when", error.what());
      }
      if (!changes_anything(actors, stage, before) && !actors.blank->depends_on_time())
        root.sub("Steps")
          .sub(stage.name)
          .fail("End time",
                "nothing changes in stage '" + stage.name +
                  "': no tool moves, no load or support varies, nothing is released, and the material does not depend "
                  "on the rate");
      before = &stage;
    }
  }
} // namespace deltaform
