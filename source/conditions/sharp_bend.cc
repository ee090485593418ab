#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <deal.II/base/numbers.h>

namespace deltaform
{
  namespace
  {
    /// Can the elements follow the sheet where it bends? They are smooth curves that keep delta, and so no other
    /// condition sees that they are too long.
    class SharpBend : public SavedCondition<SharpBend>
    {
    public:
      explicit SharpBend(const Actors &actors)
        : has_tools_(!actors.tools.empty())
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        // An element that is halved at once has bent by less in all but this increment.
        if (!has_tools_ || !increment.is_last_here)
          return;
        const SharpestBend &now = increment.sharpest_bend();
        if (now.angle <= worst_.angle)
          return;
        worst_ = now;
        time_ = increment.time;
      }

      std::string failure(const Stage &) override
      {
        return worst_.angle > unusable ? sentence() + ", and forces may be wrong by any factor. " + advice() : "";
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (worst_.angle <= doubtful || worst_.angle > unusable) // which ended the run
          return {};
        return {"sharp bend: " + sentence() + ": forces may be a fifth off, thickness and draw-in as well. " +
                advice() + "."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &worst_.angle &worst_.place &worst_.length &time_;
      }

    private:
      // Up to the first the cup's forces are within a percent of those of a fine mesh (doc/measured/cup_bend.csv), up
      // to the second the forces of most random scenes within a fifth; of those above half cannot be used
      // (doc/stress.md).
      static constexpr double degree = dealii::numbers::PI / 180., doubtful = 15. * degree, unusable = 60. * degree;
      // In thicknesses: what is shorter is not too long for any radius that a shell can follow.
      static constexpr double shortest = .5;

      bool is_short() const
      {
        return worst_.length <= shortest;
      }

      std::string sentence() const
      {
        const std::string angle = text::rounded(worst_.angle / degree), place = text::rounded(worst_.place),
                          time = text::rounded(time_);
        if (is_short())
          return "the sheet bends by " + angle + " degrees within " + text::rounded(worst_.length) +
                 " of its thickness at R0 = " + place + ", at time " + time +
                 ". The corner there is too sharp for a shell";
        return "the element at R0 = " + place + " bends by " + angle + " degrees, at time " + time +
               ". It is too long for the radius there";
      }

      std::string advice() const
      {
        return is_short() ? "Give the tool a larger radius, or model the blank as a solid (Blank/Kind = solid)"
                          : "Take shorter elements (Blank/Elements, Grading)";
      }

      bool has_tools_; ///< moments alone bend elements evenly, and these are exact then
      SharpestBend worst_;
      double time_ = 0.; ///< of the worst bend
    };

    const ConditionMakers::Entry
      entry("sharp bend", "an element of a sheet bends by more than it can follow", make_condition<SharpBend>);
  } // namespace
} // namespace deltaform
