#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Do tools bend a shell within a few thicknesses? The sheet between them carries so much transverse shear that it
     * flows by it. A shell's shear is elastic: it does not know that work, and puts the bend where it is not. A peak of
     * some increments, as where a tool touches first, does not matter: it is asked for the work that is done meanwhile.
     */
    class ShearedShell : public SavedCondition<ShearedShell>
    {
    public:
      explicit ShearedShell(const Actors &actors)
        : has_tools_(!actors.tools.empty())
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        constexpr double looks = 20.; // at a stage
        const double pause = (increment.stage.end - increment.stage.begin) / looks;
        if (!has_tools_ || (!increment.ends_stage && increment.time < last_look_ + pause))
          return;
        last_look_ = increment.time;
        const EnergyAccount &account = increment.energies();
        const double work = account.tool_work + account.load_work;
        const LargestShear &now = increment.largest_shear();
        const bool much = now.share > doubtful;
        of_work_.add(std::abs(work - work_), much);
        of_looks_.add(1., much);
        work_ = work;
        if (!much)
          return;
        if (now.share <= share_)
          return;
        share_ = now.share;
        place_ = now.place;
        time_ = increment.time;
      }

      std::vector<std::string> warnings(bool) const override
      {
        // Where energies are switched off, no work is known.
        const bool is_counted = of_work_.all > 0.;
        const Part &part = is_counted ? of_work_ : of_looks_;
        if (!(part.sheared > enough * part.all))
          return {};
        return {"sheared shell: at time " + text::rounded(time_) + " the sheet carries a transverse shear of " +
                text::rounded(share_) + " of its flow stress, at R0 = " + text::rounded(place_) + ", and more than " +
                text::rounded(doubtful) + " in " + text::percent(part.sheared / part.all) +
                (is_counted ? " of the work" : " of the time") +
                ". It flows by it, what a shell does not know: forces may be up to an eighth too small. "
                "Model the blank as a solid of degree 2 (Blank/Kind = solid), or give the tools larger radii or more "
                "clearance."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &last_look_ &work_ &of_work_.all &of_work_.sheared &of_looks_.all &of_looks_.sheared;
        archive &share_ &place_ &time_;
      }

    private:
      static constexpr double doubtful = .35, enough = .1; // doc/stress.md, A shell or a solid

      /// A sum, and what of it came while there was much shear.
      struct Part
      {
        double all = 0., sheared = 0.;

        void add(const double what, const bool much)
        {
          all += what;
          sheared += much ? what : 0.;
        }
      };

      bool has_tools_;
      double last_look_ = std::numeric_limits<double>::lowest();
      double work_ = 0.; ///< of tools and loads so far
      Part of_work_, of_looks_; ///< changes of work from look to look; looks
      double share_ = 0.; ///< largest
      double place_ = 0.; ///< R0 (length)
      double time_ = 0.;
    };

    const ConditionMakers::Entry
      entry("sheared shell", "a shell carries a transverse shear that it flows by", make_condition<ShearedShell>);
  } // namespace
} // namespace deltaform
