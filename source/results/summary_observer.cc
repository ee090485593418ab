// summary.json and timing.json, and the last lines on the console.
#include <deltaform/base/atomic_file.h>
#include <deltaform/base/command_line.h>
#include <deltaform/model/accepted_increment.h>
#include <deltaform/results/observers.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace deltaform
{
  namespace
  {
    const char *in_words(const int status)
    {
      switch (status)
      {
      case exit_status::done:
        return "done";
      case exit_status::not_converged:
        return "not converged";
      default:
        return "promise p <= delta could not be kept";
      }
    }

    class SummaryObserver : public Observer
    {
    public:
      SummaryObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), output_(output)
      {
      }

      Turn turn() const override
      {
        return Turn::sums_up;
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        cost_ += increment.cost;
        promise_ = std::max(promise_, increment.contact().max_penetration_over_delta);
        between_ = std::max(between_, increment.contact().max_penetration_between_nodes);
        remember(increment);
      }

      void moved(const AcceptedIncrement &increment) override
      {
        if (increment.number > 0)
          remember(increment);
      }

      void ended(const Model &model, const RunOutcome &outcome) override
      {
        folder_.behind().wait();
        // Names of scenes may be in another encoding than UTF-8: their bytes must not spoil the file.
        const std::string summary =
          described(model, outcome).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
        write_file_atomically(folder_.path("summary.json"), [&](std::ostream &out) { out << summary << '\n'; });
        write_file_atomically(folder_.path("timing.json"),
                              [&](std::ostream &out) { folder_.timers().write_json(out); });
        folder_.journal().finish_progress();
        folder_.journal().note(last_line(model, outcome));
        folder_.journal().note("results in " + folder_.name());
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << cost_.rounds << cost_.correction_iterations << cost_.cutbacks << promise_ << between_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> cost_.rounds >> cost_.correction_iterations >> cost_.cutbacks >> promise_ >> between_;
      }

    private:
      void remember(const AcceptedIncrement &increment)
      {
        any_ = true;
        time_ = increment.time;
        thinnest_ = increment.smallest_thickness();
        if (output_.energies)
          energy_error_ = increment.energies().error();
      }

      /// Numbers that are not finite become null.
      nlohmann::ordered_json described(const Model &model, const RunOutcome &outcome) const
      {
        nlohmann::ordered_json summary{{"title", folder_.title()},
                                       {"units", folder_.units_label()},
                                       {"version", DELTAFORM_VERSION},
                                       {"exit_status", outcome.exit_status},
                                       {"outcome", in_words(outcome.exit_status)}};
        if (!outcome.message.empty())
          summary["message"] = outcome.message;
        summary["warnings"] = outcome.warnings;
        summary["unknowns"] = model.committed().size();
        summary["increments"] = outcome.increments;
        summary["newton_iterations"] = outcome.iterations;
        summary["penalty_rounds"] = cost_.rounds;
        summary["penalty_iterations"] = cost_.correction_iterations;
        summary["cutbacks"] = cost_.cutbacks;
        summary["time"] = time_;
        summary["tools"] = nlohmann::ordered_json::object();
        for (unsigned int i = 0; any_ && i < model.actors().tools.size(); ++i)
          summary["tools"][model.actors().tools[i]->name()] = {{"travel", model.travel(i)},
                                                               {"force_z", model.tool_forces()[i][1]},
                                                               {"force_r", model.tool_forces()[i][0]}};
        summary["min_thickness"] = thinnest_;
        summary["max_penetration_over_delta"] = promise_;
        summary["max_penetration_between_nodes"] = between_;
        if (output_.energies)
          summary["energy_error"] = energy_error_;
        summary["seconds"] = folder_.timers().total();
        return summary;
      }

      std::string last_line(const Model &model, const RunOutcome &outcome) const
      {
        std::string line;
        if (const auto main = output_.main_tool; main != invalid_index && any_)
          line = fmt::format("{}: travel {:.4g}, force {:.6g}; thinnest {:.4g}; ",
                             model.actors().tools[main]->name(),
                             model.travel(main),
                             model.tool_forces()[main][1],
                             thinnest_);
        line += fmt::format("{} increments, {} Newton iterations, {:.2f} s",
                            outcome.increments,
                            outcome.iterations,
                            folder_.timers().total());
        if (model.actors().keeps_promise())
          line += fmt::format("; max p/delta {:.3f}", promise_);
        return line;
      }

      ResultsFolder &folder_;
      const OutputSettings &output_;
      IncrementCost cost_; ///< of the run
      double promise_ = 0., between_ = 0.; ///< largest p/delta and penetration between nodes of the run
      bool any_ = false; ///< was any increment accepted?
      double time_ = 0., thinnest_ = 0., energy_error_ = 0.; ///< of the last accepted increment
    };

    const ObserverMakers::Entry
      entry("summary", "summary.json and timing.json", make_observer<SummaryObserver>);
  } // namespace
} // namespace deltaform
