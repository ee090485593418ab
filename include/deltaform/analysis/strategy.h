#pragma once

#include <deltaform/analysis/newton.h>
#include <deltaform/model/increment_problem.h>

#include <memory>
#include <optional>
#include <vector>

namespace deltaform
{
  /// What an increment starts from, besides the committed state.
  struct IncrementStart
  {
    double time; ///< at which it ends
    double ratio; ///< of its length to that of the last one; 0: there is none that it continues
    bool extrapolate; ///< may Newton start from the last increment's velocity?
    const Vector &before; ///< the unknowns one increment before the committed state
  };

  /// One way to solve an increment. An increment tries those of its ladder in turn, each from the committed state.
  class Strategy
  {
  public:
    virtual ~Strategy() = default;

    /// Begin the increment. @return where Newton's method starts; nothing if this way is none for the problem
    virtual std::optional<Vector> begin(IncrementProblem &problem, const IncrementStart &start) const = 0;

    virtual NewtonVariant variant() const = 0;

    /// Is it worth its cost only where shorter increments do not help? There the blank may snap to another equilibrium,
    /// however short the increment is.
    virtual bool is_last_resort() const
    {
      return variant() != NewtonVariant::plain;
    }
  };

  using Ladder = std::vector<std::unique_ptr<Strategy>>;

  /// The strategies in the order in which an increment tries them.
  Ladder usual_ladder();

  std::unique_ptr<Strategy> make_plain_strategy();
  std::unique_ptr<Strategy> make_soft_first_touch();
  std::unique_ptr<Strategy> make_damped_strategy();
  std::unique_ptr<Strategy> make_damped_strategy_with_slack();
} // namespace deltaform
