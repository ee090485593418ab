#pragma once

#include <deltaform/blanks/sheet_section.h>
#include <deltaform/increment/increment_cost.h>
#include <deltaform/increment/strategy.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  struct StepSettings;

  /// Why an increment was given up.
  struct Rejected
  {
    enum class Kind : unsigned char
    {
      not_solved, ///< no strategy found an equilibrium
      promise_broken, ///< there is one, but the blank penetrates a tool by more than delta
      too_large ///< there is one, but it strains or turns the blank too much
    };

    Kind kind;
    std::string sentence; ///< what happened, and where
    std::string residuals = {}; ///< of the attempt, for the log
    std::vector<SheetSection> sections = {}; ///< of the sheet in an equilibrium that is refused for its strain; else none
  };

  /// What became of an attempt at an increment.
  struct IncrementResult
  {
    std::optional<Rejected> rejected; ///< nothing if it was accepted
    Vector q; ///< the state that was found
    IncrementCost cost; ///< of all strategies together
    unsigned int iterations_to_equilibrium = 0; ///< of these, without the corrections of the last solve
    bool by_last_resort = false; ///< solved by a strategy that is tried where shorter increments do not help
    double size = 0; ///< largest strain or rotation over the one that is allowed; 0 of a snap
    IncrementSize snap; ///< of a snap that is accepted, what is more than allowed, or half as much
    double strain_at_rest = 0; ///< of a point, if more than allowed, in a new equilibrium at the same time

    /// Those that say how long the next increment should be; nothing of a last resort, which does not depend on it.
    std::optional<unsigned int> iterations_of_its_length() const
    {
      return by_last_resort ? std::nullopt : std::make_optional(iterations_to_equilibrium);
    }

    /// Length of an increment that is just as large as allowed, at the rates of this one of @p length.
    double longest(const double length) const
    {
      return size > 0. ? length / size : std::numeric_limits<double>::infinity();
    }
  };

  /**
   * One increment: tries the strategies of its ladder, each from the committed state of the problem, until one finds an
   * equilibrium, and judges whether it can be accepted. The committed state stays as it is.
   */
  class Increment
  {
  public:
    Increment(IncrementProblem &problem, Newton &newton, const StepSettings &settings, Ladder ladder = usual_ladder());

    /// An increment without length is a new equilibrium at the same time.
    IncrementResult attempt(const IncrementStart &start, Effort effort);

  private:
    /// Is the step to @p result too large? Remembers a snap, and the strain of a new equilibrium at the same time.
    std::optional<Rejected> too_large(double length, bool may_snap, IncrementResult &result) const;

    /// Why a solve failed, in words.
    std::string explain(const NewtonResult &result) const;

    IncrementProblem &problem_;
    Newton &newton_;
    const StepSettings &settings_;
    Ladder ladder_;
  };
} // namespace deltaform
