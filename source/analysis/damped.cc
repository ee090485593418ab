// Where the blank snaps through: it moves to the next equilibrium as in a viscous medium. With slack, points of contact
// that carry next to nothing need not decide whether they touch.
#include <deltaform/analysis/strategy.h>

namespace deltaform
{
  namespace
  {
    class Damped : public Strategy
    {
    public:
      explicit Damped(const NewtonVariant variant)
        : variant_(variant)
      {
      }

      std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const override
      {
        problem.begin(start.time, start.ratio);
        return problem.committed();
      }

      NewtonVariant variant() const override
      {
        return variant_;
      }

    private:
      NewtonVariant variant_;
    };
  } // namespace


  std::unique_ptr<Strategy> make_damped_strategy()
  {
    return std::make_unique<Damped>(NewtonVariant::damped);
  }


  std::unique_ptr<Strategy> make_damped_strategy_with_slack()
  {
    return std::make_unique<Damped>(NewtonVariant::with_slack);
  }
} // namespace deltaform
