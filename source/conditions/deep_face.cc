#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  namespace
  {
    /// Does the face stay out of the tools between the contact points, where nothing is promised? At sharp corners no
    /// mesh can.
    class DeepFace : public SavedCondition<DeepFace>
    {
    public:
      explicit DeepFace(const Actors &actors)
        : actors_(actors)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        const auto &now = increment.contact().deepest;
        if (now.depth <= depth_)
          return;
        depth_ = now.depth;
        over_delta_ = now.over_delta;
        r_ = now.place[0];
        z_ = now.place[1];
        tool_ = now.tool;
        time_ = increment.time;
      }

      std::vector<std::string> warnings(bool) const override
      {
        // A share of the thickness of a shell, of the shortest contact edge of a solid.
        constexpr double largest_of_sheet = .05, largest_of_solid = .15;
        const Blank &blank = *actors_.blank;
        const bool is_sheet = blank.fields().is_sheet();
        const double share = depth_ / blank.typical_length();
        if (share <= (is_sheet ? largest_of_sheet : largest_of_solid))
          return {};
        std::string text = "deep face: between its contact points the blank is " + text::rounded(depth_) +
                           " deep in tool '" + actors_.tools[tool_]->name() + "', " + text::percent(share) +
                           (is_sheet ? " of the thickness" : " of the shortest contact edge");
        if (actors_.keeps_promise())
          text += " and " + text::rounded(over_delta_) + " times delta";
        return {text + ", at r = " + text::rounded(r_) + ", z = " + text::rounded(z_) + ", time " +
                text::rounded(time_) +
                ": the elements are long for the radius of the tool there. Take shorter ones (Blank/Elements, "
                "Grading)" +
                (is_sheet && blank.surface().points_per_edge() == 0 ? ", or Blank/Contact points = gauss." : ".")};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &depth_ &over_delta_ &r_ &z_ &tool_ &time_;
      }

    private:
      const Actors &actors_;
      double depth_ = 0., over_delta_ = 0., r_ = 0., z_ = 0., time_ = 0.; ///< of the worst increment
      unsigned int tool_ = 0;
    };

    const ConditionMakers::Entry
      entry("deep face", "the blank is deep in a tool between contact points", make_condition<DeepFace>);
  } // namespace
} // namespace deltaform
