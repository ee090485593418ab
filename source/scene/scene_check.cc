// What is wrong with a scene although every entry by itself is allowed.
#include <deltaform/base/ranks.h>
#include <deltaform/base/text.h>
#include <deltaform/model/reported_columns.h>
#include <deltaform/model/tool_placement.h>
#include <deltaform/scene/scene.h>

#include <cmath>
#include <limits>
#include <map>

namespace deltaform
{
  void Scene::check(Section root) const
  {
    check_functions(root);
    check_columns(root);
    check_tools(root);
    check_stages(root);
    check_linear_solver(root);
    if (!actors.tools.empty())
      check_delta(root);
    check_friction(root);
  }


  void Scene::check_friction(Section root) const
  {
    FrictionInput at_elastic_surface;
    at_elastic_surface.normal_force = at_elastic_surface.area = 1.;
    if (std::isfinite(actors.blank->initial_flow_stress()))
      return;
    for (const auto &pair : actors.interfaces)
      if (pair->friction() && !std::isfinite(pair->friction()->limit(at_elastic_surface).value))
        root.sub("Tools")
          .sub(pair->tool().name())
          .fail("Friction law",
                "is bounded by the flow stress of the blank alone, and an elastic material has none: take coulomb, or "
                "Material/Model = elastoplastic");
  }


  void Scene::check_linear_solver(Section root) const
  {
    if (linear_solver->iterative() && actors.contact && actors.contact->enforcement->has_multiplier())
      root.sub("Solver").fail("Linear solver",
                              "'" + linear_solver->name +
                                "' cannot solve with the multipliers of this enforcement: take klu or mumps");
    const bool part = actors.blank->locally_owned_dofs().n_elements() < actors.blank->n_dofs();
    if (output->condition_every > 0 && ranks::max(part ? 1. : 0.) > 0)
      root.sub("Output").fail("Condition number every",
                              "a condition number needs the whole matrix in one process: start without mpirun");
  }


  namespace
  {
    // Contact only pushes: a tool that is pulled leaves the blank and has no equilibrium.
    void check_force(const Tool &tool, const Stage &stage, const Section &section)
    {
      constexpr unsigned int n_samples = 200;
      double largest = 0.;
      for (unsigned int k = 0; k <= n_samples; ++k)
        largest = std::max(largest, std::abs(tool.force(stage.begin + (stage.end - stage.begin) * k / n_samples)));
      for (unsigned int k = 0; k <= n_samples; ++k)
      {
        const double time = stage.begin + (stage.end - stage.begin) * k / n_samples, force = tool.force(time);
        if (force < -1e-12 * largest)
          section.fail(
            "Force",
            "tool '" + tool.name() + "' is pulled off the blank at t = " + text::rounded(time) +
              ", where its force is " + text::rounded(force) +
              ". A force is positive: it presses the tool along Direction against the blank. Turn "
              "Direction round if that is what is meant, give the tool a Motion, or let it end with a stage");
      }
    }
  } // namespace


  void Scene::check_functions(Section root) const
  {
    // NaN passes most comparisons: look for it where a function of time is used.
    const auto inspect = [](const auto &function, const Stage &stage, const Section &section,
                            const std::string &entry) {
      constexpr unsigned int n_samples = 50;
      for (unsigned int k = 0; k <= n_samples; ++k)
      {
        const double time = stage.begin + (stage.end - stage.begin) * k / n_samples;
        if (!std::isfinite(function(time)))
          section.fail(entry, "is no finite number at t = " + text::format(time));
      }
    };
    for (const auto &stage : actors.stages)
    {
      for (const auto &tool : actors.tools)
        if (tool->exists_in(stage.name))
        {
          const Section section = root.sub("Tools").sub(tool->name());
          if (tool->force_driven())
          {
            inspect([&](const double time) { return tool->force(time); }, stage, section, "Force");
            check_force(*tool, stage, section);
          }
          else
            inspect([&](const double time) { return tool->travel(time); }, stage, section, "Motion");
        }
      for (const auto &support : actors.supports)
        if (support.acts_in(stage.name) && !support.hold)
          for (unsigned int i = 0; i < support.dofs.size(); ++i)
            if (i == 0 || !support.values.empty())
              inspect([&](const double time) { return support.at(i, time); },
                      stage,
                      root.sub("Supports").sub(support.name),
                      "Value");
      for (const auto &load : actors.loads)
        if (load->acts_in(stage.name))
          inspect(load->value(), stage, root.sub("Loads").sub(load->name()), "Value");
    }
  }


  void Scene::check_columns(Section root) const
  {
    // What the columns of history.csv begin with, and the name behind it.
    std::map<std::string, std::string> taken;
    const auto take = [&](const char *section, const std::string &name, const std::vector<std::string> &endings) {
      for (const auto &ending : endings)
      {
        const std::string column = column_name(name) + ending;
        const auto [other, fresh] = taken.emplace(column, name);
        if (!fresh)
          root.sub(section).fail("Names",
                                 "'" + other->second + "' and '" + name + "' would both have the column '" + column +
                                   "' of history.csv, where underscores stand for blanks: rename one of them");
      }
    };
    for (const auto &tool : actors.tools)
      take("Tools", tool->name(), {"_travel", "_force_z", "_force_r"});
    for (const auto &support : actors.supports)
      take("Supports", support.name, {"_reaction"});
    for (const auto &load : actors.loads)
      take("Loads", load->name(), {"_force_z", "_force_r"});
  }


  void Scene::check_tools(Section root) const
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
      // What comes later is checked when it comes: the blank has another shape then (Model::misplaced_tool).
      if (tool.exists_in(actors.stages.front().name))
      {
        if (const auto wrong = find_misplacement(*actors.blank, *actors.interfaces[i], zero, tool.travel(0.), 1e-9 * h))
          section.fail(wrong->entry, wrong->message);
        const double opening = tool.shape().opening();
        if (opening > 0 && outermost <= opening)
          section.fail("Throat radius",
                       "the blank ends at r = " + text::format(outermost) + " and falls through the opening of tool '" +
                         tool.name() + "', radius " + text::format(opening));
      }
      for (const auto &name : tool.stages())
      {
        bool known = false;
        for (const auto &stage : actors.stages)
          known |= stage.name == name;
        if (!known)
          section.fail("Stages", "there is no stage '" + name + "'");
      }
    }
  }


  void Scene::check_stages(Section root) const
  {
    const auto known = [&](const std::vector<std::string> &names, Section section) {
      for (const auto &name : names)
      {
        bool found = false;
        for (const auto &stage : actors.stages)
          found |= stage.name == name;
        if (!found)
          section.fail("Stages", "there is no stage '" + name + "'");
      }
    };
    for (const auto &support : actors.supports)
      known(support.stages, root.sub("Supports").sub(support.name));
    for (const auto &load : actors.loads)
      known(load->stages(), root.sub("Loads").sub(load->name()));

    const Stage *before = nullptr;
    for (const auto &stage : actors.stages)
    {
      // Does a function of time change within the stage, or does something end with the stage before?
      bool changes = false;
      const auto varies = [&](const TimeFunction &function) {
        if (function.is_constant())
          return false;
        for (unsigned int k = 1; k <= 50; ++k)
          if (function(stage.begin + (stage.end - stage.begin) * k / 50) != function(stage.begin))
            return true;
        return false;
      };
      for (const auto &tool : actors.tools)
      {
        const auto range = tool->travel_range(stage.begin, stage.end);
        changes |= tool->exists_in(stage.name) && range.first != range.second;
        if (tool->force_driven() && tool->exists_in(stage.name))
          changes = true;
        changes |= before && tool->exists_in(before->name) != tool->exists_in(stage.name);
      }
      for (const auto &support : actors.supports)
      {
        if (support.acts_in(stage.name) && !support.hold)
          for (const auto &value : support.values.empty() ? std::vector<TimeFunction>{support.value} : support.values)
            changes |= varies(value) || (!before && value(stage.end) != 0);
        changes |= before && support.acts_in(before->name) != support.acts_in(stage.name);
      }
      for (const auto &load : actors.loads)
      {
        changes |= load->acts_in(stage.name) && (varies(load->value()) || (!before && load->value()(stage.end) != 0));
        changes |= before && load->acts_in(before->name) != load->acts_in(stage.name);
      }
      if (!changes)
        root.sub("Steps")
          .sub(stage.name)
          .fail("End time",
                "nothing changes in stage '" + stage.name +
                  "': no tool moves, no load or support varies, nothing is released");
      before = &stage;
    }
  }


  void Scene::check_delta(Section root) const
  {
    double size = actors.blank->initial_thickness();
    for (const auto &x : actors.blank->positions(Vector(actors.blank->n_dofs())))
      size = std::max(size, x.norm());
    // A coordinate is rounded by half an ulp.
    const double smallest = .5e6 * std::numeric_limits<double>::epsilon() * size;
    const auto inspect = [&](const double delta, const std::string &text, Section section) {
      if (delta < 0 && text.find("auto") != std::string::npos)
        return; // bounded below by a millionth of the thickness
      if (!(delta > 0))
        section.fail("Allowed penetration", "must be positive at all times; it is " + text::format(delta));
      if (actors.contact->rule->promises() && actors.contact->enforcement->uses_penalty() && delta < smallest)
        section.fail("Allowed penetration",
                     text::format(delta) + " cannot be told from round-off: at coordinates of size " +
                       text::format(size) + " the noise of the contact forces exceeds 1e-6 of them below " +
                       text::format(smallest) +
                       ". Use Enforcement = active set, or the augmented Lagrangian, for contact that exact");
    };
    for (const auto &stage : actors.stages)
      for (unsigned int k = 0; k <= 200; ++k)
        for (const auto &tool : actors.tools)
        {
          const double time = stage.begin + (stage.end - stage.begin) * k / 200.;
          const TimeFunction *own = tool->allowed_penetration();
          const TimeFunction &chosen = own ? *own : actors.contact->allowed_penetration;
          inspect(chosen(time), chosen.text(), own ? root.sub("Tools").sub(tool->name()) : root.sub("Contact"));
        }
  }
} // namespace deltaform
