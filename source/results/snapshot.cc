#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/snapshot.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    MixedTable contact_of(const Model &model)
    {
      MixedTable table;
      table.columns = {{"tool", "1"},
                       {"R0", "length"},
                       {"penetration", "length"},
                       {"delta", "length"},
                       {"epsilon", "force/length"},
                       {"normal_force", "force"},
                       {"pressure", "stress"},
                       {"slip", "length"},
                       {"tangential_force", "force"},
                       {"status", "1"},
                       {"S0", "length"}};
      for (const auto *interface : model.interfaces())
        for (unsigned int i = 0; i < interface->n_points(); ++i)
        {
          const ContactPointState &state = interface->committed()[i];
          if (!state.touching)
            continue;
          const ContactPoint node = interface->accepted_point(model.committed(), i);
          table.rows.push_back({interface->tool().name(),
                                node.reference_coordinate,
                                state.penetration(),
                                state.delta,
                                state.penalty_factor,
                                state.force,
                                node.area > 0 ? state.force / node.area : 0.,
                                state.slip,
                                state.tangential_force,
                                std::string(interface->friction() == nullptr ? "frictionless"
                                            : state.sticking                 ? "stick"
                                                                             : "slip"),
                                node.arc_coordinate});
        }
      return table;
    }

    MixedTable outlines_of(const Model &model)
    {
      double reach = 0.;
      for (const auto &x : model.blank().positions(model.committed()))
        reach = std::max(reach, x.norm());
      MixedTable table;
      table.columns = {{"tool", "1"}, {"r", "length"}, {"z", "length"}};
      for (const auto *interface : model.interfaces())
        for (const auto &x : interface->tool().polyline(interface->travel(model.committed()), reach))
          table.rows.push_back({interface->tool().name(), x[0], x[1]});
      return table;
    }
  } // namespace


  Snapshot take_snapshot(const Model &model, const OutputSettings &output, const std::string &stage, const double time)
  {
    return {stage,
            time,
            output.main_tool == invalid_index ? time : model.travel(output.main_tool),
            model.blank().fields().profile(model.committed()),
            contact_of(model),
            outlines_of(model)};
  }


  bool asks_for_tables(const OutputSettings &output, const AcceptedIncrement &increment)
  {
    if (output.at_stage_ends && increment.ends_stage)
      return true;
    const auto &times = output.travel_times;
    return std::any_of(times.begin(), times.end(), [time = increment.time](const double asked) {
      return std::abs(time - asked) <= 1e-9 * std::max(1., std::abs(asked));
    });
  }
} // namespace deltaform
