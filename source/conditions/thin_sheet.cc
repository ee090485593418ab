#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// Is the sheet thinner than any sheet metal that is whole?
    class ThinSheet : public SavedCondition<ThinSheet>
    {
    public:
      explicit ThinSheet(const Actors &actors)
        : is_sheet_(actors.blank->fields().is_sheet()), initial_(actors.blank->initial_thickness()), thinnest_(initial_)
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        thinnest_ = std::min(thinnest_, increment.smallest_thickness());
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double least_ratio = 1. / 3.;
        if (!is_sheet_ || thinnest_ >= least_ratio * initial_)
          return {};
        return {"thickness: the sheet is " + text::rounded(thinnest_) + " thin at its thinnest point, " +
                text::percent(thinnest_ / initial_) + " of what it was. A real sheet has torn before."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &thinnest_;
      }

    private:
      bool is_sheet_;
      double initial_, thinnest_;
    };

    const ConditionMakers::Entry
      entry("thin sheet", "the sheet is thinner than one that is whole", make_condition<ThinSheet>);
  } // namespace
} // namespace deltaform
