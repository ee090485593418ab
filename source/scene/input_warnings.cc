#include <deltaform/checks/doubtful_solid.h>
#include <deltaform/checks/overlapping_tools.h>
#include <deltaform/checks/rigid_motions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/parameters/unit_system.h>
#include <deltaform/scene/contact_edge.h>
#include <deltaform/scene/earlier_operation.h>
#include <deltaform/scene/input_warnings.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    using Texts = std::vector<std::string>;

    void rigid_motions(const Actors &actors, Texts &result)
    {
      for (const auto &stage : actors.stages)
      {
        std::string motions;
        for (const auto &motion : free_rigid_motions(actors, stage))
          motions += (motions.empty() ? "" : ", ") + motion;
        if (motions.empty())
          continue;
        result.push_back("stage '" + stage.name +
                         "': neither a support nor contact without friction keeps the blank from moving as a "
                         "whole (" +
                         motions + "). " +
                         (actors.blank->axisymmetric()
                            ? std::string("Hold it along z, for example by a support with Hold = true.")
                            : std::string("Hold it by Supports: at a plane of symmetry by Component = r and (shell) "
                                          "rotation; where all tools have "
                                          "left, also by Component = z with Hold = true.")));
      }
    }

    void short_elements(const Blank &blank, Texts &result)
    {
      if (!blank.fields().is_sheet())
        return;
      const auto nodes = blank.positions(Vector(blank.n_dofs()));
      const double h = blank.initial_thickness();
      double shortest = std::numeric_limits<double>::infinity();
      Point2 place;
      for (const auto &edge : blank.surface().contact_edges(Side::top))
        if (const double length = nodes[edge[0]].distance(nodes[edge[1]]); length < shortest)
        {
          shortest = length;
          place = nodes[edge[0]];
        }
      if (shortest < .25 * h * (1. - 1e-9))
        result.push_back(
          "Blank: the shortest element, at r = " + text::rounded(place[0]) + ", is " + text::rounded(shortest) +
          " long, less than a quarter of the thickness " + text::rounded(h) +
          ". A shell knows no such detail: contact forces alternate from node to node, and thinning shows "
          "spikes. Take fewer Elements, a milder Grading, or a solid.");
    }

    void soft_material(const Blank &blank, Texts &result)
    {
      const double flow = blank.initial_flow_stress();
      if (std::isfinite(flow) && blank.surface().modulus() < 100. * flow)
        result.push_back(
          "Material: Young's modulus " + text::rounded(blank.surface().modulus()) + " is only " +
          text::rounded(blank.surface().modulus() / flow) + " times the initial flow stress " + text::rounded(flow) +
          "; of metals it is 200 to 1000 times. Elastic strains are taken to be small: look at the units.");
    }

    /// Values that no metal and no sheet has, if the label of the units is right.
    void doubtful_units(const Scene &scene, Texts &result)
    {
      const UnitSystem unit_system(scene.units);
      if (const std::string misspelt = unit_system.misspelt(); !misspelt.empty())
        result.push_back("Units = " + scene.units + ": " + misspelt +
                         ". With an unknown unit, modulus and thickness are not looked at.");
      const Blank &blank = *scene.actors.blank;
      constexpr double softest = 1e10, stiffest = 7e11; // Pa: lead, tungsten carbide
      const double modulus = blank.surface().modulus();
      if (unit_system.stress && std::isfinite(blank.initial_flow_stress()) &&
          (modulus * *unit_system.stress < softest || modulus * *unit_system.stress > stiffest))
        result.push_back("Material: a Young's modulus of " + text::rounded(modulus * *unit_system.stress / 1e9) +
                         " GPa is that of no metal (10 to 700): look at the modulus and at Units = " + scene.units +
                         ".");
      constexpr double thinnest = 1e-6, thickest = .2; // m
      const double thickness = blank.initial_thickness();
      if (unit_system.length && blank.fields().is_sheet() &&
          (thickness * *unit_system.length < thinnest || thickness * *unit_system.length > thickest))
        result.push_back("Blank: a sheet of " + text::rounded(thickness * *unit_system.length * 1e3) +
                         " mm is none that is formed: look at Thickness and at Units = " + scene.units + ".");
    }

    void doubtful_friction(const Actors &actors, Texts &result)
    {
      for (const auto &interface : actors.interfaces)
        if (interface->friction() && !interface->friction()->doubt().empty())
          result.push_back("Tools/" + interface->tool().name() + "/" + interface->friction()->doubt());
    }


    /// A delta that changes the part: measured by the thickness of a sheet, and by the edges of a solid, whose cells
    /// may be far shorter than it is thick.
    void loose_delta(const Actors &actors, Texts &result)
    {
      if (actors.tools.empty() || !actors.contact->rule->promises() || !actors.contact->normal_law->uses_penalty())
        return;
      const bool is_sheet = actors.blank->fields().is_sheet();
      const double largest = is_sheet ? .1 : .05;
      const double natural = is_sheet ? actors.blank->initial_thickness() : shortest_contact_edge(*actors.blank);
      const std::string rest =
        is_sheet ? " of the thickness: radii and gaps are off by as much. State 1e-3*thickness."
                 : " of the shortest contact edge, which is " + text::rounded(natural) +
                     " long: contact forces and places suffer. 'thickness' is the thickness of a solid, not of its "
                     "cells: state 1e-3*edge.";
      for (const auto &tool : actors.tools)
      {
        const TimeFunction *const own = tool->allowed_penetration();
        const TimeFunction &chosen = own != nullptr ? *own : actors.contact->allowed_penetration;
        const double delta = chosen(actors.stages.front().begin);
        if (!(delta > largest * natural * (1. + 1e-9)))
          continue;
        result.push_back((own != nullptr ? "Tools/" + tool->name() + "/" : std::string("Contact/")) +
                         "Allowed penetration = " + chosen.text() + " is " + text::rounded(delta) + ", " +
                         text::percent(delta / natural) + rest);
        if (own == nullptr)
          return;
      }
    }


    /// The number of processes must not decide on a result without a word.
    void shared_at_nodes(const Blank &blank, Texts &result)
    {
      if (blank.shared_at_nodes())
        result.emplace_back("Blank/Contact points: several processes share the solid, and it touches at its nodes; in "
                            "one process it touches inside its edges, with other forces. State Contact points = nodes "
                            "to have the same history on any number of processes.");
    }


    void gripped_solid(const Actors &actors, Texts &result)
    {
      if (actors.blank->fields().is_sheet())
        return;
      for (const auto &stage : actors.stages)
      {
        std::vector<ToolWall> walls;
        for (const auto &tool : actors.tools)
          if (tool->exists_in(stage.name))
            for (auto &wall : walls_along_z(tool->name(), tool->side(), tool->shape()))
            {
              wall.r += tool->position()[0];
              walls.push_back(std::move(wall));
            }
        for (auto &text : doubtful_solid(actors.blank->initial_thickness(), walls))
          if (std::find(result.begin(), result.end(), text) == result.end())
            result.push_back(std::move(text));
      }
    }
  } // namespace


  std::vector<std::string> input_warnings(const Scene &scene)
  {
    Texts result;
    rigid_motions(scene.actors, result);
    short_elements(*scene.actors.blank, result);
    soft_material(*scene.actors.blank, result);
    doubtful_units(scene, result);
    doubtful_friction(scene.actors, result);
    loose_delta(scene.actors, result);
    shared_at_nodes(*scene.actors.blank, result);
    gripped_solid(scene.actors, result);
    for (auto &text : doubts_about_start(scene))
      result.push_back(std::move(text));
    for (auto &text : overlapping_tools(scene.actors))
      result.push_back(std::move(text));
    return result;
  }
} // namespace deltaform
