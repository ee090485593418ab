// Points that touch for the first time are soft at first and are stiffened after each converged solve: a stiff first
// touch throws the blank back, and Newton's method goes to and fro between touching and not.
#include <deltaform/increment/strategy.h>

namespace deltaform
{
  namespace
  {
    class SoftFirstTouch : public Strategy
    {
    public:
      std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const override
      {
        constexpr double share_of_stiffness = 1e-4;
        problem.begin(start.time, start.ratio());
        if (!problem.soften(share_of_stiffness))
          return std::nullopt;
        return problem.committed();
      }

      Effort least_effort() const override
      {
        return Effort::usual;
      }
    };

    const StrategyMakers::Entry entry("soft first touch",
                                      "first touches are soft, and stiffened after each converged solve",
                                      []() -> std::unique_ptr<Strategy> { return std::make_unique<SoftFirstTouch>(); });
  } // namespace
} // namespace deltaform
