// Where the run is, on the console.
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/observers.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class ProgressObserver : public Observer
    {
    public:
      ProgressObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), output_(output)
      {
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        iterations_ += increment.cost.iterations;
        worst_ = std::max(worst_, increment.contact().max_penetration_over_delta);
        if (!folder_.journal().wants_progress())
          return;
        const Model &model = increment.model;
        std::string line =
          fmt::format("increment {}  {} t = {:.4g}", increment.number, increment.stage.name, increment.time);
        if (const auto main = output_.main_tool; main != invalid_index)
          line += fmt::format("  {}: travel {:.4g}, force {:.4g}",
                              model.actors().tools[main]->name(),
                              model.travel(main),
                              model.tool_forces()[main][1]);
        line += fmt::format("  iterations {}", iterations_);
        if (model.actors().keeps_promise())
          line += fmt::format("  penetration/delta <= {:.3f}", worst_);
        const double end = model.actors().stages.back().end, spent = folder_.timers().total();
        line += fmt::format("  left {:.1f} s", spent * (end - increment.time) / std::max(increment.time, 1e-300));
        folder_.journal().progress(line);
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << iterations_ << worst_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> iterations_ >> worst_;
      }

    private:
      ResultsFolder &folder_;
      const OutputSettings &output_;
      unsigned int iterations_ = 0;
      double worst_ = 0.; ///< largest penetration/delta
    };

    const ObserverMakers::Entry
      entry("progress", "a line on the console", make_observer<ProgressObserver>);
  } // namespace
} // namespace deltaform
