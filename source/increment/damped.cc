// Where the blank snaps through: it moves to the next equilibrium as in a viscous medium. With a tolerance, points
// that carry next to nothing need not decide whether they touch.
#include <deltaform/increment/strategy.h>

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

    template <NewtonVariant variant>
    std::unique_ptr<Strategy> make()
    {
      return std::make_unique<Damped>(variant);
    }

    const StrategyMakers::Entry damped("damped", "as in a viscous medium", make<NewtonVariant::damped>);
    const StrategyMakers::Entry with_tolerance("damped with status tolerance",
                                               "the same, and contact that carries next to nothing may be either",
                                               make<NewtonVariant::with_tolerance>);
  } // namespace
} // namespace deltaform
