#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/reported_columns.h>

#include <algorithm>
#include <limits>

namespace deltaform
{
  namespace
  {
    using Increment = AcceptedIncrement;
    using Row = Columns::Row;

    Columns::Cell number(const unsigned int n)
    {
      return static_cast<double>(n);
    }
  } // namespace


  ReportedNames reported_names(const Actors &actors)
  {
    ReportedNames names;
    for (const auto &tool : actors.tools)
      names.tools.push_back(tool->name());
    for (const auto &support : actors.supports)
      names.supports.push_back(support.name);
    for (const auto &load : actors.loads)
    {
      names.loads.push_back(load->name());
      (load->pressed_face().empty() ? names.other_loads : names.pressures).push_back(load->name());
      if (load->restraint())
        names.beads.push_back(load->name());
    }
    names.probes = actors.probes;
    return names;
  }


  void describe_increment(Columns &columns)
  {
    columns.add({{"increment", "1", "counts from 1"},
                 {"stage", "1", "stage of the scene"},
                 {"time", "time", "at the end of the increment"}},
                [](const Increment &increment, Row &row) {
                  row.insert(row.end(), {number(increment.number), increment.stage.name, increment.time});
                });
  }


  void describe_tools(const std::vector<std::string> &names, Columns &columns)
  {
    for (unsigned int i = 0; i < names.size(); ++i)
    {
      const std::string tool = text::column_name(names[i]);
      columns.add({{tool + "_travel", "length",
                    "along the tool's direction of motion, from its initial position"},
                   {tool + "_force_z", "force",
                    "of the blank on the tool, friction included; of a tool that ended with the stage before, "
                    "what is left of its force while it [fades out](theory/contact.md#release)"},
                   {tool + "_force_r", "force",
                    "of the blank on the tool; on a ring the radial components point outwards all round, and "
                    "this is their sum"}},
                  [i](const Increment &increment, Row &row) {
                    const Tensor1 &force = increment.model.tool_forces()[i];
                    row.insert(row.end(), {increment.model.travel(i), force[1], force[0]});
                  });
    }
  }


  void describe_cost(Columns &columns)
  {
    columns.add({{"newton_iterations", "1", "of the increment, failed attempts included"},
                 {"penalty_rounds", "1", "converged solves after which a rule corrected its factors"},
                 {"penalty_iterations", "1",
                  "of the iterations, those that the corrections of factors cost"},
                 {"cutbacks", "1", "attempts at this increment that failed"}},
                [](const Increment &increment, Row &row) {
                  const IncrementCost &cost = increment.cost;
                  row.insert(row.end(), {number(cost.iterations), number(cost.rounds),
                                         number(cost.correction_iterations), number(cost.cutbacks)});
                });
  }


  void describe_contact(Columns &columns)
  {
    columns.add({{"max_penetration", "length",
                  "largest penetration of a contact point into a tool. Of a shell, that of its face, which the contact "
                  "force has compressed by (t/2) pressure/E (`Thickness compliance`, "
                  "[theory](theory/contact.md#thickness-compliance))"},
                 {"max_penetration_over_delta", "1",
                  "largest penetration/delta: with rule `adaptive` never above 1 (but for 1e-6 of it, or round-off)"},
                 {"max_penetration_between_nodes", "length",
                  "deepest place of the face in a tool, also between contact points; what it is deeper than these "
                  "is an error of the mesh"},
                 {"min_epsilon", "force/length", "smallest penalty factor of what touches"},
                 {"max_epsilon", "force/length", "largest penalty factor of what touches"},
                 {"floor_share", "1",
                  "share of the touching points whose penalty factor is at its lower bound, not lambda/delta"},
                 {"contact_pairs", "1", "touching contact points; one between two tools counts twice"}},
                [](const Increment &increment, Row &row) {
                  const ContactAccount &contact = increment.contact();
                  row.insert(row.end(), {contact.max_penetration, contact.max_penetration_over_delta,
                                         contact.max_penetration_between_nodes, contact.min_epsilon,
                                         contact.max_epsilon, contact.floor_share, number(contact.n_touching)});
                });
  }


  void describe_thickness(Columns &columns)
  {
    columns.add({{"min_thickness", "length", "smallest current thickness at an integration point"}},
                [](const Increment &increment, Row &row) { row.emplace_back(increment.smallest_thickness()); });
  }


  void describe_criteria(const std::vector<LargestCriterion> &criteria, Columns &columns)
  {
    for (unsigned int k = 0; k < criteria.size(); ++k)
    {
      const std::string &name = criteria[k].column;
      columns.add({{name, criteria[k].unit, "largest value in the blank"},
                   {name + "_R0", "length", "where it is, in the undeformed blank"},
                   {name + "_Z0", "length", "where it is, in the undeformed blank"}},
                  [k](const Increment &increment, Row &row) {
                    const LargestCriterion &largest = increment.largest_criteria()[k];
                    row.insert(row.end(), {largest.value, largest.place[0], largest.place[1]});
                  });
    }
  }


  void describe_wrinkling(Columns &columns)
  {
    columns.add({{"wrinkling_factor", "1",
                  "by which the stresses of the flange would have to grow until it wrinkles without a holder; empty: "
                  "it does not, or there is none"},
                 {"wrinkling_waves", "1", "around the circumference, of that wrinkling"},
                 {"wrinkling_pressure", "stress", "of a holder that keeps waves of the height `Wrinkle height` down"},
                 {"holder_pressure", "stress", "mean normal contact stress on the top of the flange"}},
                [](const Increment &increment, Row &row) {
                  const auto &[wrinkles, pressure] = increment.wrinkling();
                  row.insert(row.end(), {Columns::if_known(wrinkles.factor), number(wrinkles.waves),
                                         wrinkles.pressure, pressure});
                });
  }


  void describe_linear_solver(Columns &columns)
  {
    columns.add({{"linear_iterations", "1", "iterations of the linear solver, failed attempts included"}},
                [](const Increment &increment, Row &row) { row.push_back(number(increment.cost.linear_iterations)); });
  }


  void describe_mesh(Columns &columns)
  {
    columns.add({{"unknowns", "1", "of the mesh"},
                 {"cells", "1", "of the mesh"},
                 {"estimated_error", "1",
                  "relative error in energy before the last refinement; empty before the first. A row with the time of "
                  "the one before is the new equilibrium after a refinement: tools stand still, its iterations are its "
                  "cost"}},
                [](const Increment &increment, Row &row) {
                  // A blank that keeps its mesh does not say anything of it.
                  const Adaptive *mesh = increment.model.blank().adaptive();
                  row.insert(row.end(), {number(increment.model.committed().size()),
                                         mesh != nullptr ? number(mesh->n_cells()) : Columns::Cell(std::string()),
                                         mesh != nullptr ? Columns::if_known(mesh->estimated_error())
                                                         : Columns::Cell(std::string())});
                });
  }


  void describe_energies(Columns &columns)
  {
    columns.add({{"tool_work", "force*length", "work of the moving tools on the blank"},
                 {"elastic_energy", "force*length",
                  "stored in the blank now: material, and the shell's transverse shear"},
                 {"plastic_energy", "force*length", "dissipated in the blank so far"},
                 {"friction_energy", "force*length",
                  "dissipated by slip so far; a point that touches or lets go within an increment counts with half "
                  "its force over the increment's slip ([how exact](theory/friction.md#friction-work))"},
                 {"contact_energy", "force*length",
                  "stored in the penalty springs now: eps penetration²/2, and t²/(2 eps_t) of sticking friction"},
                 {"epsilon_work", "force*length",
                  "what the springs gain beyond the work of their forces on the blank: by changed penalty factors, "
                  "half the change times the penetrations before and after; and where the straight way of a point "
                  "between two states is not that across the tool ([energies](theory/contact.md#energies))"},
                 {"thickness_work", "force*length",
                  "work done by what is updated between increments: the thickness that keeps tools from the "
                  "mid-surface, the places of contact points inside the elements, the layers' distance to the "
                  "mid-surface, and the transverse normal stress"},
                 {"load_work", "force*length", "work of loads and of prescribed displacements"},
                 {"energy_error", "1",
                  "(tool_work + load_work + epsilon_work + thickness_work - elastic - plastic - friction - "
                  "contact) over the largest of tool work, load work and their sum on the other side"}},
                [](const Increment &increment, Row &row) {
                  const EnergyAccount &account = increment.energies();
                  row.insert(row.end(), {account.tool_work, account.elastic, account.plastic, account.friction,
                                         account.contact, account.epsilon_work, account.thickness_work,
                                         account.load_work, account.error()});
                });
  }


  void describe_heat(Columns &columns)
  {
    columns.add({{"min_temperature", "temperature", "smallest at a node"},
                 {"max_temperature", "temperature", "largest at a node"},
                 {"heat_stored", "force*length", "in the blank, over that at its initial temperature"},
                 {"heat_of_flow", "force*length", "made by plastic flow so far"},
                 {"heat_of_friction", "force*length", "the blank's share of it so far"},
                 {"heat_to_tools", "force*length", "through the touching points so far"},
                 {"heat_to_surroundings", "force*length", "by films so far"},
                 {"heat_error", "1",
                  "stored - (flow + friction - tools - surroundings) over the largest of them: round-off"}},
                [](const Increment &increment, Row &row) {
                  const HeatFlow &heat = *increment.model.actors().heat;
                  const auto temperatures = heat.temperatures();
                  const auto [least, most] = std::minmax_element(temperatures.begin(), temperatures.end());
                  const HeatAccount &account = heat.account();
                  row.insert(row.end(), {*least, *most, account.stored, account.flow, account.friction, account.tools,
                                         account.surroundings, account.error()});
                });
  }


  void describe_half_spaces(Columns &columns)
  {
    columns.add({{"min_tool_temperature", "temperature", "smallest at the surfaces of these tools, where points of the "
                                                         "blank have been or are"},
                 {"max_tool_temperature", "temperature", "largest there"}},
                [](const Increment &increment, Row &row) {
                  const auto [least, most] = *increment.model.actors().heat->tool_temperatures();
                  row.insert(row.end(), {least, most});
                });
  }


  void describe_supports(const std::vector<std::string> &names, Columns &columns)
  {
    for (unsigned int i = 0; i < names.size(); ++i)
      columns.add({{text::column_name(names[i]) + "_reaction", "force",
                    "sum of the forces (moments) of a support on the blank, without loads on its own nodes; "
                    "symmetry at the axis does not count. A corner that two supports hold is in both sums"}},
                  [i](const Increment &increment, Row &row) { row.emplace_back(increment.model.reaction(i)); });
  }


  void describe_loads(const std::vector<std::string> &names, Columns &columns)
  {
    for (unsigned int i = 0; i < names.size(); ++i)
    {
      const std::string load = text::column_name(names[i]);
      columns.add({{load + "_force_z", "force", "resultant of a load on the blank"},
                   {load + "_force_r", "force", "resultant of a load on the blank"}},
                  [i](const Increment &increment, Row &row) {
                    const Tensor1 &force = increment.model.load_force(i);
                    row.insert(row.end(), {force[1], force[0]});
                  });
    }
  }


  void describe_earlier_operation(Columns &columns)
  {
    columns.add({{"earlier_operation_force_z", "force",
                  "resultant of what is left of the forces that held the blank in the operation before; what supports "
                  "of this one hold is in their reactions"},
                 {"earlier_operation_force_r", "force", "the same"}},
                [](const Increment &increment, Row &row) {
                  const Tensor1 force = increment.model.earlier_force();
                  row.insert(row.end(), {force[1], force[0]});
                });
  }


  void describe_balance(Columns &columns)
  {
    columns.add({{"balance_error", "1",
                  "sum of the forces of tools, supports and loads on the blank over the largest of them, along "
                  "z (plane strain: and along x; the larger counts). Where none is a thousandth of the largest "
                  "of the run (moments over the thickness): over that thousandth"}},
                [](const Increment &increment, Row &row) { row.emplace_back(increment.balance_error()); });
  }
} // namespace deltaform
