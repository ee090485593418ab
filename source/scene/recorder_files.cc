// What stands in the rows and tables.
#include "recorder_files.h"

#include <deltaform/base/text.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/results/table_file.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  HistoryRow Recorder::Files::row(const FormingProblem &problem,
                                  const Stage &stage,
                                  const double time,
                                  const unsigned int increment,
                                  const IncrementCost &cost) const
  {
    HistoryRow row;
    row.increment = increment;
    row.stage = stage.name;
    row.time = time;
    row.newton_iterations = cost.iterations;
    row.penalty_rounds = cost.rounds;
    row.penalty_iterations = cost.correction_iterations;
    row.linear_iterations = cost.linear_iterations;
    if (cost.condition)
    {
      row.condition_raw = cost.condition->raw;
      row.condition_scaled = cost.condition->scaled;
      row.condition_without_contact = cost.condition->without_contact;
      row.digits_lost = cost.condition->digits_lost;
      row.rigid_modes = cost.condition->n_rigid;
    }
    row.cutbacks = cost.cutbacks;
    row.unknowns = problem.committed().size();
    row.cells = scene.actors.blank->n_cells();
    row.estimated_error = scene.actors.blank->estimated_error();
    for (unsigned int i = 0; i < scene.actors.tools.size(); ++i)
      row.tools.push_back({problem.travel(i), problem.tool_forces()[i][1], problem.tool_forces()[i][0]});

    for (unsigned int i = 0; i < scene.actors.supports.size(); ++i)
      row.reactions.push_back(problem.reaction(i));
    for (unsigned int i = 0; i < scene.actors.loads.size(); ++i)
      row.load_forces.push_back({{problem.load_force(i)[0], problem.load_force(i)[1]}});
    row.balance_error = problem.balance_error();

    unsigned int governed = 0;
    row.min_epsilon = std::numeric_limits<double>::infinity();
    for (const auto *pair : problem.active_pairs())
    {
      for (unsigned int i = 0; i < pair->n_nodes(); ++i)
      {
        const ContactPointState &state = pair->committed()[i];
        if (!state.touching)
          continue;
        ++row.contact_pairs;
        row.max_penetration = std::max(row.max_penetration, state.penetration());
        row.max_penetration_over_delta = std::max(row.max_penetration_over_delta, state.penetration() / state.delta);
        row.min_epsilon = std::min(row.min_epsilon, state.penalty_factor);
        row.max_epsilon = std::max(row.max_epsilon, state.penalty_factor);
        governed += pair->governed_by_floor(i);
      }
      row.max_penetration_between_nodes =
        std::max(row.max_penetration_between_nodes, penetration_between_nodes(*pair, problem.committed()));
    }
    if (row.contact_pairs == 0)
      row.min_epsilon = 0.;
    else
      row.floor_share = static_cast<double>(governed) / row.contact_pairs;

    row.min_thickness = scene.actors.blank->smallest_thickness();
    if (scene.output->energies)
      add_energies(problem, row);
    return row;
  }


  void Recorder::Files::add_energies(const FormingProblem &problem, HistoryRow &row) const
  {
    ContactEnergy contact;
    for (const auto &pair : scene.actors.pairs)
      contact += pair->energy();
    const BlankEnergy blank = scene.actors.blank->energy();
    row.tool_work = problem.work().tools;
    row.load_work = problem.work().loads;
    row.elastic_energy = blank.elastic;
    row.plastic_energy = blank.plastic;
    row.friction_energy = contact.friction;
    row.friction_error = contact.friction_error();
    row.contact_energy = contact.stored;
    row.epsilon_work = contact.epsilon;
    row.thickness_work = contact.thickness + blank.normal;
    const double in = row.tool_work + row.load_work + row.epsilon_work + row.thickness_work;
    const double out = row.elastic_energy + row.plastic_energy + row.friction_energy + row.contact_energy;
    const double size = std::max({std::abs(row.tool_work), std::abs(row.load_work), std::abs(out)});
    row.energy_error = size > 0 ? (in - out) / size : 0.;
  }


  void Recorder::Files::write_tables(const FormingProblem &problem, const double travel, const std::string &stage)
  {
    // A stage in which the main tool rests must not overwrite the tables of the one before.
    std::string label = text::format(std::round(travel * 1e6) / 1e6);
    if (!labels.insert(label).second)
      labels.insert(label += "_" + stage);
    auto head = comments;
    head.push_back("stage " + stage + ", travel of the main tool (or time): " + text::format(travel));
    behind.run([path = folder + "/profile_" + label + ".csv",
                profile = scene.actors.blank->profile(problem.committed()),
                head,
                this]() { write_table(path, head, profile, units); });
    if (scene.actors.tools.empty())
      return;

    double reach = 0.;
    for (const auto &x : scene.actors.blank->positions(problem.committed()))
      reach = std::max(reach, x.norm());
    Rows tools;
    for (const auto *pair : problem.active_pairs())
      for (const auto &x : pair->tool().polyline(pair->travel(problem.committed()), reach))
        tools.push_back({pair->tool().name(), x[0], x[1]});
    behind.run(
      [contact_path = folder + "/contact_" + label + ".csv",
       contact = contact_rows(problem),
       tools_path = folder + "/tools_" + label + ".csv",
       tools = std::move(tools),
       head,
       this]() {
        write_table(contact_path,
                    head,
                    {{"tool", "1"},
                     {"R0", "length"},
                     {"penetration", "length"},
                     {"delta", "length"},
                     {"epsilon", "force/length"},
                     {"normal_force", "force"},
                     {"pressure", "stress"},
                     {"slip", "length"},
                     {"tangential_force", "force"},
                     {"status", "1"},
                     {"S0", "length"}},
                    contact,
                    units);
        write_table(tools_path, head, {{"tool", "1"}, {"r", "length"}, {"z", "length"}}, tools, units);
      });
  }


  Recorder::Files::Rows Recorder::Files::contact_rows(const FormingProblem &problem)
  {
    Rows rows;
    for (const auto *pair : problem.active_pairs())
      for (unsigned int i = 0; i < pair->n_nodes(); ++i)
      {
        const ContactPointState &state = pair->committed()[i];
        if (!state.touching)
          continue;
        const ContactNode node = pair->node(problem.committed(), i);
        rows.push_back({pair->tool().name(),
                        node.reference_coordinate,
                        state.penetration(),
                        state.delta,
                        state.penalty_factor,
                        state.force,
                        node.area > 0 ? state.force / node.area : 0.,
                        state.slip,
                        state.tangential_force,
                        std::string(!pair->friction() ? "frictionless"
                                    : state.sticking  ? "stick"
                                                      : "slip"),
                        node.arc_coordinate});
      }
    return rows;
  }
} // namespace deltaform
