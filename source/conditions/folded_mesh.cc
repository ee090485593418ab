#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  namespace
  {
    /// Has metal flowed so far that the mesh of a solid folds over itself? Equations that look at the points of
    /// integration only do not notice.
    class FoldedMesh : public SavedCondition<FoldedMesh>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        const FoldedCells &now = increment.folded_cells();
        if (now.share <= share_)
          return;
        share_ = now.share;
        r_ = now.place[0];
        z_ = now.place[1];
        time_ = increment.time;
      }

      std::string failure(const Stage &) override
      {
        return share_ > unusable ? "the mesh has folded over: " + sentence() : "";
      }

      std::string likely_cause(const std::vector<SheetSection> &) const override
      {
        return share_ > doubtful ? "the mesh folds over: " + sentence() : "";
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (share_ <= doubtful || share_ > unusable) // which ended the run
          return {};
        return {"folded mesh: " + sentence() + "."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &share_ &r_ &z_ &time_;
      }

    private:
      // A forging whose surface cells are folded in 9 % of the section still has shape and force of a forging; an
      // extrusion in whose container they are in 13 % has not (doc/decisions/README.md).
      static constexpr double doubtful = .01, unusable = .1;

      std::string sentence() const
      {
        return "in " + text::percent(share_) + " of the section, at time " + text::rounded(time_) +
               ", cells are turned inside out at a corner (the largest of them was at R0 = " + text::rounded(r_) +
               ", Z0 = " + text::rounded(z_) +
               "). The metal has flowed further there than these elements can follow. Look at the pictures; take less "
               "friction (Friction law = coulomb with limit), a larger radius, or elements that are longer across the "
               "flow";
      }

      double share_ = 0., r_ = 0., z_ = 0., time_ = 0.; ///< of the worst increment
    };

    const ConditionMakers::Entry
      entry("folded mesh", "the mesh of a solid folds over; far enough it ends the run", make_condition<FoldedMesh>);
  } // namespace
} // namespace deltaform
