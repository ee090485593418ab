// profile_*.csv, contact_*.csv and tools_*.csv, where a scene asks for them.
#include <deltaform/base/command_line.h>
#include <deltaform/base/text.h>
#include <deltaform/model/accepted_increment.h>
#include <deltaform/results/observers.h>
#include <deltaform/results/table_file.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/set.hpp>
#include <boost/serialization/string.hpp>

#include <cmath>
#include <set>
#include <utility>

namespace deltaform
{
  namespace
  {
    using Rows = std::vector<std::vector<CsvWriter::Cell>>;

    const std::vector<CsvWriter::Column> contact_columns = {{"tool", "1"},
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

    Rows contact_rows(const Model &model)
    {
      Rows rows;
      for (const auto *interface : model.interfaces())
        for (unsigned int i = 0; i < interface->n_nodes(); ++i)
        {
          const ContactPointState &state = interface->committed()[i];
          if (!state.touching)
            continue;
          const ContactNode node = interface->node(model.committed(), i);
          rows.push_back({interface->tool().name(),
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
      return rows;
    }

    Rows tool_rows(const Model &model)
    {
      double reach = 0.;
      for (const auto &x : model.blank().positions(model.committed()))
        reach = std::max(reach, x.norm());
      Rows rows;
      for (const auto *interface : model.interfaces())
        for (const auto &x : interface->tool().polyline(interface->travel(model.committed()), reach))
          rows.push_back({interface->tool().name(), x[0], x[1]});
      return rows;
    }

    class TableObserver : public Observer
    {
    public:
      TableObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), output_(output)
      {
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
        if (!increment.is_last_here)
          return;
        for (const double asked : output_.travel_times)
          if (std::abs(time_ - asked) <= 1e-9 * std::max(1., std::abs(asked)))
            write(increment.model);
      }

      void moved(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
      }

      /// A run that stopped shows its last state.
      void ended(const Model &model, const RunOutcome &outcome) override
      {
        if (outcome.exit_status != exit_status::done && outcome.increments > 0)
          write(model);
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << labels_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> labels_;
      }

    private:
      void write(const Model &model)
      {
        const double travel = output_.main_tool == invalid_index ? time_ : model.travel(output_.main_tool);
        // A stage in which the main tool rests must not overwrite the tables of the one before.
        std::string label = text::format(std::round(travel * 1e6) / 1e6);
        if (!labels_.insert(label).second)
          labels_.insert(label += "_" + stage_);
        auto head = folder_.comments();
        head.push_back("stage " + stage_ + ", travel of the main tool (or time): " + text::format(travel));
        folder_.behind().run([path = folder_.path("profile_" + label + ".csv"),
                              profile = model.blank().profile(model.committed()), head,
                              units = folder_.units()]() { write_table(path, head, profile, units); });
        if (model.actors().tools.empty())
          return;
        folder_.behind().run([contact_path = folder_.path("contact_" + label + ".csv"),
                              contact = contact_rows(model), tools_path = folder_.path("tools_" + label + ".csv"),
                              tools = tool_rows(model), head, units = folder_.units()]() {
          write_table(contact_path, head, contact_columns, contact, units);
          write_table(tools_path, head, {{"tool", "1"}, {"r", "length"}, {"z", "length"}}, tools, units);
        });
      }

      ResultsFolder &folder_;
      const OutputSettings &output_;
      double time_ = 0.; ///< of the last accepted increment, and its stage
      std::string stage_;
      std::set<std::string> labels_; ///< of the tables written so far
    };

    const ObserverMakers::Entry
      entry("tables", "profile_*.csv, contact_*.csv and tools_*.csv", make_observer<TableObserver>);
  } // namespace
} // namespace deltaform
