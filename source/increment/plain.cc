// Newton's method from where the last increments lead.
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
        problem.begin(start.time, start.ratio());
        Vector q = problem.committed();
        if (start.extrapolate)
          start.predictor.predict(start.length, q, start.chain);
        return q;
      }
    };

    const StrategyMakers::Entry entry("plain",
                                      "Newton's method from where the last increments lead",
                                      []() -> std::unique_ptr<Strategy> { return std::make_unique<Plain>(); });
  } // namespace
} // namespace deltaform
