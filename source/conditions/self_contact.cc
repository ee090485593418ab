#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  namespace
  {
    /// Does a sheet lie within itself, as a hem that is closed too far? Nothing but tools keeps it apart. In scenes
    /// without tools it may: a strip rolled up by a moment, to a full turn and more, is a test of shells.
    class SelfContact : public SavedCondition<SelfContact>
    {
    public:
      explicit SelfContact(const Actors &actors)
        : has_tools_(!actors.tools.empty())
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        if (!has_tools_)
          return;
        const Overlap &now = increment.overlap();
        if (now.share <= share_)
          return;
        share_ = now.share;
        first_ = now.first;
        second_ = now.second;
      }

      std::string failure(const Stage &) override
      {
        // A hem that is closed flat may be pressed by a little more than its springs of contact give.
        constexpr double largest = .1;
        if (share_ <= largest)
          return "";
        return "the sheet passes through itself: its parts at R0 = " + text::rounded(first_) + " and " +
               text::rounded(second_) + " overlap by " + text::percent(share_) +
               " of the thickness. Contact is between blank and tools only: end the stage before, or put a tool "
               "between them";
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &share_ &first_ &second_;
      }

    private:
      bool has_tools_;
      double share_ = 0., first_ = 0., second_ = 0.; ///< of the worst increment
    };

    const ConditionMakers::Entry
      entry("self contact", "a sheet passes through itself; ends the run", make_condition<SelfContact>);
  } // namespace
} // namespace deltaform
