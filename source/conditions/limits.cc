#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <map>

namespace deltaform
{
  namespace
  {
    /// Does a criterion of the blank reach the limit that the scene sets to it? The first time counts.
    class Limits : public SavedCondition<Limits>
    {
    public:
      explicit Limits(const Actors &actors)
        : limits_(actors.limits)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        if (reached_.size() == limits_.size())
          return;
        for (const auto &limit : limits_)
          for (const auto &largest : increment.largest_criteria())
            if (largest.name == limit.criterion && largest.value >= limit.most && reached_.count(limit.criterion) == 0)
              reached_[limit.criterion] = {increment.stage.name, sentence(limit, largest, increment.time)};
      }

      std::string failure(const Stage &) override
      {
        return first(Limit::Then::end_run, "");
      }

      std::string stage_end(const Stage &stage) const override
      {
        return first(Limit::Then::end_stage, stage.name);
      }

      std::vector<std::string> warnings(bool) const override
      {
        std::vector<std::string> result;
        for (const auto &[criterion, what] : reached_)
          result.push_back("limit: " + what.second + ".");
        return result;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &reached_;
      }

    private:
      static std::string sentence(const Limit &limit, const LargestCriterion &largest, const double time)
      {
        return "'" + limit.criterion + "' is " + text::rounded(largest.value) + " at R0 = " +
               text::rounded(largest.place[0]) + ", Z0 = " + text::rounded(largest.place[1]) + " at time " +
               text::rounded(time) + "; the limit is " + text::rounded(limit.most) + " (Limits/" +
               limit.criterion + ")";
      }

      /// What was reached, of the limits with this consequence. @param stage in which; empty: any
      std::string first(const Limit::Then then, const std::string &stage) const
      {
        for (const auto &limit : limits_)
          if (const auto one = reached_.find(limit.criterion);
              limit.then == then && one != reached_.end() && (stage.empty() || one->second.first == stage))
            return one->second.second;
        return "";
      }

      std::vector<Limit> limits_;
      std::map<std::string, std::pair<std::string, std::string>> reached_; ///< by criterion: stage, sentence
    };

    const ConditionMakers::Entry
      entry("limits", "a criterion reaches its limit: warns, ends the stage or the run", make_condition<Limits>);
  } // namespace
} // namespace deltaform
