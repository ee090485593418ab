// Where the run is, on the console.
#include <deltaform/model/accepted_increment.h>
#include <deltaform/results/observers.h>

#include "short_number.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

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
        std::string line = "increment " + std::to_string(increment.number) + "  " + increment.stage.name +
                           " t = " + short_number(increment.time);
        if (const auto main = output_.main_tool; main != invalid_index)
          line += "  " + model.actors().tools[main]->name() + ": travel " + short_number(model.travel(main)) +
                  ", force " + short_number(model.tool_forces()[main][1]);
        line += "  iterations " + std::to_string(iterations_);
        if (model.keeps_promise())
          line += "  p/delta <= " + short_number(worst_, "%.3f");
        const double end = model.actors().stages.back().end, spent = folder_.timers().total();
        line += "  left " + short_number(spent * (end - increment.time) / std::max(increment.time, 1e-300), "%.1f") +
                " s";
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
      double worst_ = 0.; ///< p/delta
    };
  } // namespace


  std::unique_ptr<Observer> make_progress_observer(ResultsFolder &folder, const OutputSettings &output)
  {
    return std::make_unique<ProgressObserver>(folder, output);
  }
} // namespace deltaform
