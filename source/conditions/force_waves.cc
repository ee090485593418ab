#include <deltaform/conditions/conditions.h>
#include <deltaform/conditions/turning_points.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deltaform
{
  namespace
  {
    /// The force of a tool that moves one way: its turns.
    struct OneWay
    {
      TurningPoints force;
      double begin = 0., end = 0.; ///< times
      double travel = 0.; ///< the last one
      int direction = 0; ///< of the motion; 0: it has not begun

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &force &begin &end &travel &direction;
      }
    };


    /// Does the force of a tool that moves one way go up and down, again and again? Every element that comes to a
    /// radius does that where elements are long, and all balances are closed.
    class ForceWaves : public SavedCondition<ForceWaves>
    {
    public:
      explicit ForceWaves(const Actors &actors)
        : actors_(actors), now_(actors.tools.size()), before_(actors.tools.size()), largest_(actors.tools.size(), 0.)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        for (unsigned int i = 0; i < now_.size(); ++i)
        {
          const Tool &tool = *actors_.tools[i];
          if (tool.force_driven())
            continue;
          const double travel = increment.model.travel(i), force = increment.model.tool_forces()[i] * tool.direction();
          // Another mesh at the same time
          if (increment.time == now_[i].end)
            continue;
          largest_[i] = std::max(largest_[i], std::abs(force));
          const double way = travel - now_[i].travel;
          const int direction = way > 0. ? 1 : way < 0. ? -1
                                                        : 0;
          if (direction != now_[i].direction)
          {
            if (n_swings(i, now_[i]) > n_swings(i, before_[i]))
              before_[i] = now_[i];
            now_[i] = {{}, now_[i].end, 0., 0., direction};
          }
          if (direction != 0)
            now_[i].force.add(force);
          now_[i].end = increment.time;
          now_[i].travel = travel;
        }
      }

      std::vector<std::string> warnings(bool) const override
      {
        std::vector<std::string> result;
        for (unsigned int i = 0; i < now_.size(); ++i)
        {
          const OneWay &most = n_swings(i, now_[i]) > n_swings(i, before_[i]) ? now_[i] : before_[i];
          if (n_swings(i, most) >= many)
            result.push_back(sentence(i, most));
        }
        return result;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &now_ &before_ &largest_;
      }

    private:
      // Over the largest force. The shipped processes have no swing above .15 but at the begin and the end; scenes
      // whose forces were off by a third had dozens (doc/stress.md).
      static constexpr double large = .2;
      static constexpr unsigned int many = 6;

      unsigned int n_swings(const unsigned int tool, const OneWay &way) const
      {
        return way.force.swings(large * largest_[tool]).size();
      }

      std::string sentence(const unsigned int tool, const OneWay &way) const
      {
        const std::vector<double> swings = way.force.swings(large * largest_[tool]);
        const double mean = std::accumulate(swings.begin(), swings.end(), 0.) / swings.size();
        return "force waves: the force of tool '" + actors_.tools[tool]->name() + "' turns " +
               std::to_string(swings.size()) + " times between times " + text::rounded(way.begin) + " and " +
               text::rounded(way.end) + ", by " + text::percent(mean / largest_[tool]) +
               " of the largest on average. So it does where elements are long for a radius that they come to, and its "
               "mean is too large then as well: take shorter ones (Blank/Elements). Waves that stay are those of the "
               "process, as of a flange that snaps.";
      }

      const Actors &actors_;
      std::vector<OneWay> now_, before_; ///< tool by tool: its motion now, and of those before the one with most turns
      std::vector<double> largest_; ///< force
    };

    const ConditionMakers::Entry
      entry("force waves", "the force of a tool goes up and down", make_condition<ForceWaves>);
  } // namespace
} // namespace deltaform
