// Newton's method from the last increment's velocity.
#include <deltaform/increment/strategy.h>

namespace deltaform
{
  namespace
  {
    class Plain : public Strategy
    {
    public:
      std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const override
      {
        problem.begin(start.time, start.ratio);
        Vector q = problem.committed();
        if (start.extrapolate && start.ratio > 0.)
          q.sadd(1. + start.ratio, -start.ratio, start.before);
        return q;
      }
    };

    const StrategyMakers::Entry entry("plain",
                                      "Newton's method from the last increment's velocity",
                                      []() -> std::unique_ptr<Strategy> { return std::make_unique<Plain>(); });
  } // namespace
} // namespace deltaform
