// Does the flange wrinkle, and no holder keeps the waves down? The first time counts.
#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <boost/serialization/string.hpp>

namespace deltaform
{
  namespace
  {
    class FlangeWrinkles : public SavedCondition<FlangeWrinkles>
    {
    public:
      explicit FlangeWrinkles(const Actors &actors)
        : wrinkling_(actors.wrinkling.get())
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        if (wrinkling_ == nullptr || !stage_.empty())
          return;
        // Stresses that fade out after tools have left are none of the process.
        const bool released = increment.model.interfaces().empty() && !increment.model.actors().tools.empty();
        if (released || !increment.wrinkling().wrinkles_now())
          return;
        const auto &[wrinkles, pressure] = increment.wrinkling();
        stage_ = increment.stage.name;
        sentence_ = "the flange wrinkles at time " + text::rounded(increment.time) + " in " +
                    std::to_string(wrinkles.waves) + " waves: without a holder it does at " +
                    text::rounded(wrinkles.factor) + " of its stresses. The holder presses with " +
                    text::rounded(pressure) + " on its area, " + text::rounded(wrinkles.pressure) +
                    " would keep waves of the height Limits/Wrinkle height down";
      }

      std::string failure(const Stage &) override
      {
        return ends(Limit::Then::end_run) ? sentence_ : "";
      }

      std::string stage_end(const Stage &stage) const override
      {
        return ends(Limit::Then::end_stage) && stage.name == stage_ ? sentence_ : "";
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (stage_.empty())
          return {};
        return {"wrinkling: " + sentence_ + ". Press the holder harder, or give it a smaller gap."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &stage_ &sentence_;
      }

    private:
      bool ends(const Limit::Then then) const
      {
        return !stage_.empty() && wrinkling_->then() == then;
      }

      const FlangeWrinkling *wrinkling_; ///< null: nobody asks
      std::string stage_, sentence_; ///< empty: it has not
    };

    const ConditionMakers::Entry entry("flange wrinkles",
                                       "the flange of a shell wrinkles: warns, ends the stage or the run",
                                       make_condition<FlangeWrinkles>);
  } // namespace
} // namespace deltaform
