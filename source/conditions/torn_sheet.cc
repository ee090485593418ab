#include <deltaform/conditions/conditions.h>
#include <deltaform/limits/necking.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace deltaform
{
  namespace
  {
    /// Does the sheet tear? It ends the run, unless its stage says to go on.
    class TornSheet : public SavedCondition<TornSheet>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        watch_.observe(increment.sections());
        if (std::string holding = watch_.holding(); !holding.empty())
          held_ = std::move(holding);
      }

      std::string failure(const Stage &stage) override
      {
        if (!watch_.torn())
          return "";
        held_.clear();
        if (!stage.continue_after_necking)
          return "the sheet tears: " + with_remedy(watch_.finding()) + "; to go on all the same, set Steps/" +
                 stage.name + "/Continue after necking = true and --resume";
        passed_over_ = watch_.finding();
        return "";
      }

      std::string likely_cause(const std::vector<SheetSection> &refused) const override
      {
        const std::string neck = watch_.suspicion();
        return with_remedy(neck.empty() ? watch_.at_once(refused) : neck);
      }

      std::vector<std::string> warnings(bool) const override
      {
        std::vector<std::string> result;
        if (!passed_over_.empty())
          result.push_back("necked: " + passed_over_ + ". What was computed after that depends on the mesh.");
        if (!held_.empty())
          result.push_back("past the maximum: " + held_ + ". A real sheet is less even: compare with its forming limit.");
        return result;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &watch_ &passed_over_ &held_;
      }

    private:
      static std::string with_remedy(const std::string &neck)
      {
        return neck.empty() ? "" : neck + ". Form less deep, or with less friction, less holder force or larger radii";
      }

      NeckingWatch watch_;
      std::string passed_over_; ///< the last neck with which the run went on
      std::string held_; ///< what a tool held last
    };

    const ConditionMakers::Entry
      entry("torn sheet", "the sheet necks; ends the run, unless its stage says to go on", make_condition<TornSheet>);
  } // namespace
} // namespace deltaform
