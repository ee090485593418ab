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
        : at_nodes_(actors.blank->surface().points_per_edge() == 0)
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
                (at_nodes_ ? ", or Blank/Contact points = gauss." : ".")};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &share_;
      }

    private:
      bool at_nodes_;
      double share_ = 0.; ///< of the last increment: all so far
    };

    const ConditionMakers::Entry entry("artificial friction",
                                       "contact at points resists a sheet that slides over a radius",
                                       make_condition<ArtificialFriction>);
  } // namespace
} // namespace deltaform
