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
        if (!has_tools_)
          return;
        const SharpestBend &now = increment.sharpest_bend();
        if (now.angle <= angle_)
          return;
        angle_ = now.angle;
        place_ = now.place;
        time_ = increment.time;
      }

      std::vector<std::string> warnings(bool) const override
      {
        // Below it the cup's forces are within a percent of those of a fine mesh (doc/measured/cup_bend.csv).
        constexpr double largest = 15. * dealii::numbers::PI / 180.;
        if (angle_ <= largest)
          return {};
        return {"sharp bend: the element at R0 = " + text::rounded(place_) + " bends by " +
                text::rounded(angle_ * 180. / dealii::numbers::PI) + " degrees, at time " + text::rounded(time_) +
                ". It is too long for the radius there: forces and thickness may be several percent off. Take shorter "
                "elements (Blank/Elements, Grading)."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &angle_ &place_ &time_;
      }

    private:
      bool has_tools_; ///< moments alone bend elements evenly, and these are exact then
      double angle_ = 0., place_ = 0., time_ = 0.; ///< of the worst increment
    };

    const ConditionMakers::Entry
      entry("sharp bend", "an element of a sheet bends by more than it can follow", make_condition<SharpBend>);
  } // namespace
} // namespace deltaform
