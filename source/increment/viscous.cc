// Where the blank snaps through: it moves to the next equilibrium as in a viscous medium.
#include <deltaform/increment/strategy.h>
#include <deltaform/increment/viscous_motion.h>

namespace deltaform
{
  namespace
  {
    class Viscous : public Strategy
    {
    public:
      Viscous(const unsigned int most_iterations, const Effort least_effort)
        : most_iterations_(most_iterations), least_effort_(least_effort)
      {
      }

      std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const override
      {
        problem.begin(start.time, start.ratio());
        return problem.committed();
      }

      NewtonResult solve(IncrementProblem &problem, Newton &newton, Vector &q) const override
      {
        return ViscousMotion(problem, newton, q, most_iterations_).run();
      }

      Effort least_effort() const override
      {
        return least_effort_;
      }

    private:
      unsigned int most_iterations_;
      Effort least_effort_;
    };

    template <unsigned int most_iterations, Effort least_effort>
    std::unique_ptr<Strategy> make()
    {
      return std::make_unique<Viscous>(most_iterations, least_effort);
    }

    const StrategyMakers::Entry viscous("viscous", "as in a viscous medium", make<100, Effort::last_resorts>);
    const StrategyMakers::Entry far("viscous, a long way",
                                    "the same with more iterations: a snap may be long",
                                    make<5000, Effort::all>);
  } // namespace
} // namespace deltaform
