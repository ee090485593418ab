#pragma once

#include <deltaform/increment/effort.h>
#include <deltaform/increment/increment_problem.h>
#include <deltaform/increment/newton.h>
#include <deltaform/increment/predictor.h>
#include <deltaform/parameters/makers.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// What an increment starts from, besides the committed state.
  struct IncrementStart
  {
    double time; ///< at which it ends
    double length;
    bool extrapolate; ///< may Newton start from where the last increments lead?
    const Predictor &predictor;
    const ElementChain &chain = ElementChain::none(); ///< of the blank

    /// Of its length to that of the last one; 0: there is none that it continues.
    double ratio() const
    {
      return predictor.last_length() > 0. ? length / predictor.last_length() : 0.;
    }
  };

  /// One way to solve an increment. An increment tries those of its ladder in turn, each from the committed state.
  class Strategy
  {
  public:
    virtual ~Strategy() = default;

    /// Begin the increment. @return where Newton's method starts; nothing if the strategy does not apply
    virtual std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const = 0;

    /// From @p q, where it begins, to the state that is looked for.
    virtual NewtonResult solve(IncrementProblem &problem, Newton &newton, Vector &q) const
    {
      return newton.solve(q, problem.prescribed(), problem.is_prescribed(), problem.committed(), problem.force_floor());
    }

    /// The least and the most effort with which it is tried. Last resorts are for where the blank may snap to another
    /// equilibrium, however short the increment is.
    ///@{
    virtual Effort least_effort() const
    {
      return Effort::first;
    }
    virtual Effort most_effort() const
    {
      return Effort::all;
    }
    ///@}
  };

  /// Strategies by their names. The last line of a strategy's file is an Entry.
  using StrategyMakers = Makers<Strategy>;

  using Ladder = std::vector<std::unique_ptr<Strategy>>;

  /// Strategies by their names, in the order in which an increment tries them.
  Ladder make_ladder(const std::vector<std::string> &names);

  Ladder usual_ladder();
} // namespace deltaform
