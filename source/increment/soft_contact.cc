// Contact is soft at first and is stiffened after each converged solve. A stiff first touch throws the blank back, and a
// point that is much stiffer than the sheet makes Newton's method go to and fro between sets, or leave for another
// equilibrium.
#include <deltaform/increment/strategy.h>

namespace deltaform
{
  namespace
  {
    class SoftContact : public Strategy
    {
    public:
      std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const override
      {
        problem.begin(start.time, start.ratio());
        if (!problem.soften())
          return std::nullopt;
        return problem.committed();
      }

      Effort least_effort() const override
      {
        return Effort::usual;
      }

      /// Where shorter increments did not help the blank snaps, and is on its way as soon as it may be.
      Effort most_effort() const override
      {
        return Effort::usual;
      }
    };

    const StrategyMakers::Entry entry("soft contact",
                                      "contact is soft at first, and stiffened after each converged solve",
                                      []() -> std::unique_ptr<Strategy> { return std::make_unique<SoftContact>(); });
  } // namespace
} // namespace deltaform
