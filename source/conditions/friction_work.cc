#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// How well is the work of friction known at the end (doc/theory/friction.md)?
    class FrictionWork : public SavedCondition<FrictionWork>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        const EnergyAccount &account = increment.energies();
        friction_ = account.friction;
        error_ = account.friction_error;
        work_ = std::max(account.tool_work, account.load_work);
      }

      std::vector<std::string> warnings(bool) const override
      {
        constexpr double largest = .05, worth_a_word = .01;
        if (error_ <= largest * friction_ || friction_ <= worth_a_word * work_)
          return {};
        return {"friction work: it is uncertain by about " + text::percent(error_ / friction_) +
                ", because nodes begin and end to slide within increments that are long. Set a smaller Largest "
                "increment in Steps/<stage>."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &friction_ &error_ &work_;
      }

    private:
      double friction_ = 0., error_ = 0., work_ = 0.; ///< of the last increment
    };

    const ConditionMakers::Entry
      entry("friction work", "the work of friction is uncertain", make_condition<FrictionWork>);
  } // namespace
} // namespace deltaform
