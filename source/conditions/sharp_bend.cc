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
        if (now.angle <= angle_)
          return;
        angle_ = now.angle;
        place_ = now.place;
        time_ = increment.time;
      }

      std::string failure(const Stage &) override
      {
        return angle_ > unusable ? sentence() + ", and forces may be wrong by any factor. Take shorter elements "
                                                "(Blank/Elements, Grading)"
                                 : "";
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (angle_ <= doubtful || angle_ > unusable) // which ended the run
          return {};
        return {"sharp bend: " + sentence() +
                ": forces may be a fifth off, thickness and draw-in as well. Take shorter elements (Blank/Elements, "
                "Grading)."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &angle_ &place_ &time_;
      }

    private:
      // Up to the first the cup's forces are within a percent of those of a fine mesh (doc/measured/cup_bend.csv), up
      // to the second the forces of most random scenes within a fifth; of those above half cannot be used
      // (doc/stress.md).
      static constexpr double degree = dealii::numbers::PI / 180., doubtful = 15. * degree, unusable = 60. * degree;

      std::string sentence() const
      {
        return "the element at R0 = " + text::rounded(place_) + " bends by " + text::rounded(angle_ / degree) +
               " degrees, at time " + text::rounded(time_) + ". It is too long for the radius there";
      }

      bool has_tools_; ///< moments alone bend elements evenly, and these are exact then
      double angle_ = 0., place_ = 0., time_ = 0.; ///< of the worst increment
    };

    const ConditionMakers::Entry
      entry("sharp bend", "an element of a sheet bends by more than it can follow", make_condition<SharpBend>);
  } // namespace
} // namespace deltaform
