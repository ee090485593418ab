#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/reports/accepted_increment.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Does contact at points resist a sheet that slides from one to the next (doc/theory/contact.md, "Artificial
    /// friction")? Balances are closed, and where the sheet is soft enough to snap from point to point its forces hardly
    /// wave.
    class ArtificialFriction : public SavedCondition<ArtificialFriction>
    {
    public:
      explicit ArtificialFriction(const Actors &actors)
        : other_points_(other_points(actors))
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        share_ = increment.energies().artificial_friction();
      }

      std::vector<std::string> warnings(bool) const override
      {
        // Of random strips above it most are a twentieth to a half off (doc/stress.md).
        constexpr double largest = .02;
        if (std::abs(share_) <= largest)
          return {};
        return {"artificial friction: the sheet slides over contact points that stand apart on a radius, which " +
                std::string(share_ > 0. ? "takes " : "adds ") + text::percent(std::abs(share_)) +
                " of the work: forces are wrong by a twentieth to a half, and a sheet that is held with little friction "
                "may slip in truth. Take shorter elements there (Blank/Elements, Grading)" +
                (other_points_.empty() ? "." : ", or Blank/Contact points = " + other_points_ + ".")};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &share_;
      }

    private:
      /// Contact points that slide more freely; empty: none.
      static std::string other_points(const Actors &actors)
      {
        const ContactSurface &surface = actors.blank->surface();
        if (actors.blank->fields().is_sheet())
          return surface.points_move() ? "" : "moving";
        return surface.points_per_edge() == 0 ? "gauss" : "";
      }

      std::string other_points_;
      double share_ = 0.; ///< of the last increment: all so far
    };

    const ConditionMakers::Entry entry("artificial friction",
                                       "contact at points resists a sheet that slides over a radius",
                                       make_condition<ArtificialFriction>);
  } // namespace
} // namespace deltaform
