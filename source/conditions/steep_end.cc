#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Travels and forces of a tool in this increment and the two before it, the latest first.
    struct LastIncrements
    {
      std::array<double, 3> travel{}, force{};
      double time = 0.;
      double largest = 0.; ///< force of the run
      double start = 0.; ///< travel when there was no force yet

      void add(const double at, const double new_travel, const double new_force)
      {
        // Another mesh at the same time
        if (at != time)
        {
          if (largest == 0.)
            start = travel[0];
          travel = {{new_travel, travel[0], travel[1]}};
          force = {{new_force, force[0], force[1]}};
        }
        travel[0] = new_travel;
        force[0] = new_force;
        time = at;
        largest = std::max(largest, std::abs(new_force));
      }

      /// What the last increment adds to the force, over the force.
      double rise() const
      {
        return force[0] != 0. ? 1. - force[1] / force[0] : 0.;
      }

      /// Does the force rise twice as fast with the travel as in the increment before?
      bool gets_steeper() const
      {
        const double now = (force[0] - force[1]) / (travel[0] - travel[1]),
                     before = (force[1] - force[2]) / (travel[1] - travel[2]);
        return std::isfinite(now) && std::isfinite(before) && std::abs(now) > 2. * std::abs(before);
      }

      /// What the force rises by over the travel @p way, over the force, if it goes on as in the last increment.
      double rise_over(const double way) const
      {
        const double result = rise() * way / std::abs(travel[0] - travel[1]);
        return std::isfinite(result) ? result : 0.;
      }

      /// The same over all of the travel since the tool touched: 1 of a force that is proportional to it.
      double steepness() const
      {
        return rise_over(std::abs(travel[0] - start));
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &travel &force &time &largest &start;
      }
    };


    /// Does a stage end where the force of a tool that has its place rises steeply? The metal fills the gap there, and
    /// the largest force is as good as the gap. What a hundredth of the thickness does to it does not depend on the
    /// increments.
    class SteepEnd : public SavedCondition<SteepEnd>
    {
    public:
      explicit SteepEnd(const Actors &actors)
        : actors_(actors), uncertain_(.01 * actors.blank->initial_thickness()),
          last_(actors.tools.size()), sentences_(actors.tools.size())
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        // Whether a stage ends with an increment is known when the next one begins.
        if (increment.stage.name != stage_)
        {
          for (unsigned int i = 0; i < last_.size(); ++i)
            if (const std::string now = sentence(i); !now.empty())
              sentences_[i] = now;
          stage_ = increment.stage.name;
        }
        for (unsigned int i = 0; i < last_.size(); ++i)
          if (const Tool &tool = *actors_.tools[i]; !tool.force_driven())
            last_[i].add(increment.time, increment.model.travel(i),
                         increment.model.tool_forces()[i] * tool.direction());
      }

      std::vector<std::string> warnings(bool) const override
      {
        std::vector<std::string> result;
        for (unsigned int i = 0; i < last_.size(); ++i)
          if (const std::string now = sentence(i), text = now.empty() ? sentences_[i] : now; !text.empty())
            result.push_back(text);
        return result;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &last_ &stage_ &sentences_;
      }

    private:
      // Of the force: in an increment, and over the uncertain part of the gap, where random V bends are bottomed and
      // joggles pressed (doc/stress.md). These are steep, by 15 to 160; a punch that sinks into a block is not, by 1.
      static constexpr double doubtful = .25, doubtful_over_gap = .03, steep = 10.;

      /// What is doubtful if the stage ends with the last increment; empty: nothing.
      std::string sentence(const unsigned int i) const
      {
        const LastIncrements &last = last_[i];
        if (std::abs(last.force[0]) != last.largest)
          return "";
        const double over_gap = last.rise_over(uncertain_);
        std::string way;
        if (last.rise() > doubtful && last.gets_steeper())
          way = text::percent(last.rise()) + " of itself in the last increment, over " +
                text::rounded(std::abs(last.travel[0] - last.travel[1])) + " of its travel";
        else if (over_gap > doubtful_over_gap && last.steepness() > steep)
          way = text::percent(over_gap) + " of itself over a hundredth of the thickness";
        else
          return "";
        return "steep end: at the end of stage '" + stage_ + "' the force of tool '" + actors_.tools[i]->name() +
               "' rises by " + way +
               ": it depends more on the gap that is left than on the process. End the stage at a force "
               "(Ends when), or before; or take shorter elements and a smaller Largest increment.";
      }

      const Actors &actors_;
      double uncertain_; ///< part of a gap (length)
      std::string stage_; ///< of the last increment
      std::vector<LastIncrements> last_; ///< tool by tool
      std::vector<std::string> sentences_; ///< of each; empty: none
    };

    const ConditionMakers::Entry entry("steep end",
                                       "a stage ends where the force of a tool rises steeply",
                                       make_condition<SteepEnd>);
  } // namespace
} // namespace deltaform
