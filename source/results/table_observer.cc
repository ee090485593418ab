// profile_*.csv, contact_*.csv and tools_*.csv, where a scene asks for them.
#include <deltaform/io/table_file.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/observers.h>
#include <deltaform/results/snapshot.h>

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
        if (increment.is_last_here && asks_for_tables(output_, increment))
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
        if (outcome.stopped_by_itself() && outcome.increments > 0)
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
        const Snapshot now = take_snapshot(model, output_, stage_, time_);
        // A stage in which the main tool rests must not overwrite the tables of the one before.
        std::string label = text::format(std::round(now.travel * 1e6) / 1e6);
        if (!labels_.insert(label).second)
          labels_.insert(label += "_" + stage_);
        auto head = folder_.comments();
        head.push_back("stage " + stage_ + ", travel of the main tool (or time): " + text::format(now.travel));
        folder_.writer().run([path = folder_.path("profile_" + label + ".csv"), profile = now.profile, head,
                              units = folder_.units()]() { write_table(path, head, profile, units); });
        if (model.actors().tools.empty())
          return;
        folder_.writer().run([contact_path = folder_.path("contact_" + label + ".csv"), contact = now.contact,
                              tools_path = folder_.path("tools_" + label + ".csv"), tools = now.outlines, head,
                              units = folder_.units()]() {
          write_table(contact_path, head, contact.columns, contact.rows, units);
          write_table(tools_path, head, tools.columns, tools.rows, units);
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
